#include "common/experiments/render/picture.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

double screen_level(double linear)
{
    const double c = std::clamp(linear, 0.0, 1.0);
    return 255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055);
}

}  // namespace

Picture::Picture(int width_px, int height_px, std::uint8_t grey)
    : width(width_px), height(height_px),
      rgb(3 * static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px), grey)
{}

void blend(Picture& picture, int x, int y, const Vec3& color, double share)
{
    if (x < 0 || y < 0 || x >= picture.width || y >= picture.height || share <= 0)
        return;
    std::uint8_t* pixel = picture.at(x, y);
    for (int c = 0; c < 3; ++c)
        pixel[c] =
            static_cast<std::uint8_t>(std::lround((1 - share) * pixel[c] + share * screen_level(color[c])));
}

}  // namespace enduring
