#pragma once

#include "common/scenes/scene.hpp"

namespace enduring::chapter09 {

/// Thickness and height of both beams [m].
inline constexpr double beam_size = 0.5;

/// Two beams of 3 m and 10 kg, one across the other on the plane y = 0. The upper one begins in the lower
/// one, and no vertex of either is inside the other.
/// @param depth     how deep the upper one begins in the lower one, less than beam_size [m]
/// @param turn_deg  of the upper one against the lower one, 30 to 90
/// @param aside     of the upper one's middle, along both beams [m]
Scene crossed_beams(double depth, double turn_deg, double aside, double dt);

}  // namespace enduring::chapter09
