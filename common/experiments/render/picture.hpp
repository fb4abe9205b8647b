#pragma once

#include "common/geometry/vector.hpp"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace enduring {

/// False when configured with -DENDURING_RENDER=OFF. Everything below still compiles and runs then: what is
/// drawn has no pixels, writing it writes nothing, and comparing it passes.
#ifdef ENDURING_RENDER
inline constexpr bool pictures_are_on = true;
#else
inline constexpr bool pictures_are_on = false;
#endif

/// Rows from top to bottom, three bytes (sRGB) a pixel.
struct Picture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;

    Picture() = default;
    /// @param grey  every byte of the new picture
    Picture(int width, int height, std::uint8_t grey = 255);

    bool empty() const { return rgb.empty(); }
    std::uint8_t* at(int x, int y) { return rgb.data() + offset(x, y); }
    const std::uint8_t* at(int x, int y) const { return rgb.data() + offset(x, y); }

private:
    std::size_t offset(int x, int y) const
    {
        return 3 *
               (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    }
};

/// Mixes a linear colour into a pixel; outside of the picture nothing happens.
/// @param share  of the new colour, 0 to 1
void blend(Picture& picture, int x, int y, const Vec3& color, double share);

/// Writes beside and renames; an empty picture writes nothing, and one that is not wanted (pictures_wanted())
/// takes an old one away.
/// @throws InputError  the place cannot be written
void write_png(const Picture& picture, const std::filesystem::path& path);

/// @throws InputError  no such file, or not a picture
Picture read_png(const std::filesystem::path& path);

}  // namespace enduring
