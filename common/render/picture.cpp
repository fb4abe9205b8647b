#include "common/render/picture.hpp"

namespace enduring {

Picture::Picture(int width_px, int height_px, std::uint8_t grey)
    : width(width_px), height(height_px), rgb(3 * static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px), grey)
{
}

}  // namespace enduring
