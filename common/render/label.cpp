#include "common/render/text.hpp"

namespace enduring {

void draw_label(Picture& picture, const Label& label, const Camera& camera)
{
    Eigen::Vector2d place = label.offset_px;
    if (label.anchor) {
        if (camera.depth(*label.anchor) <= 0)
            return;
        place += camera.project(*label.anchor, picture.width, picture.height);
    }
    draw_text(picture, label.text, place.x(), place.y(), label.size_px, label.color, true);
}

}  // namespace enduring
