#pragma once

#include "common/geometry/vector.hpp"

#include <array>
#include <cmath>
#include <cstdint>

namespace enduring {

/// Linear RGB in [0, 1] of a colour as web pages write it: srgb(0xc8553d).
inline Vec3 srgb(std::uint32_t hex)
{
    const auto linear = [](std::uint32_t byte) {
        const double c = static_cast<double>(byte & 255u) / 255;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return {linear(hex >> 16), linear(hex >> 8), linear(hex)};
}

namespace palette {

inline const Vec3 blue = srgb(0x5b87b8), terracotta = srgb(0xcc7a5c), sand = srgb(0xdcc69a),
                  sage = srgb(0x8aab88), plum = srgb(0x9a7fa8), slate = srgb(0x8b929c),
                  ivory = srgb(0xe9e3d6), ink = srgb(0x2d3038);

/// For bodies that no scene gave a colour, in turn.
inline const std::array<Vec3, 6> bodies{blue, terracotta, sand, sage, plum, slate};

/// The thesis' colours of features.
inline const Vec3 colliding_vertex = srgb(0xd8232a), colliding_face = srgb(0x1f4fd8),
                  colliding_edge = srgb(0x1fa34a), artefact = srgb(0xf28c1c);

}  // namespace palette
}  // namespace enduring
