#include "common/experiments/render/label.hpp"

#include <algorithm>
#include <cmath>
#include "common/experiments/render/text.hpp"

namespace enduring {
namespace {

const Vec3 plate_color = srgb(0xfbfaf7);

/// A pale rectangle with round corners; everything in pixels.
void draw_plate(Picture& picture, double left, double top, double width, double height)
{
    const double corner = 0.28 * height;
    for (int y = static_cast<int>(top) - 1; y <= static_cast<int>(top + height) + 1; ++y)
        for (int x = static_cast<int>(left) - 1; x <= static_cast<int>(left + width) + 1; ++x) {
            const double outside_x = std::max({left + corner - x, x - (left + width - corner), 0.0});
            const double outside_y = std::max({top + corner - y, y - (top + height - corner), 0.0});
            blend(picture, x, y, plate_color,
                  0.78 * std::clamp(corner - std::hypot(outside_x, outside_y), 0.0, 1.0));
        }
}

}  // namespace

void draw_label(Picture& picture, const Label& label, const Camera& camera)
{
    Eigen::Vector2d place = label.offset_px;
    if (label.anchor) {
        if (camera.depth(*label.anchor) <= 0)
            return;
        place += camera.project(*label.anchor, picture.width, picture.height);
    }
    const double size = label.size_px, margin = 0.35 * size;
    draw_plate(picture, place.x() - margin, place.y() - 0.95 * size,
               text_width(label.text, size) + 2 * margin, 1.3 * size);
    draw_text(picture, label.text, place.x(), place.y(), size, label.color);
}

}  // namespace enduring
