#pragma once

#include "common/simulation/step.hpp"

namespace enduring::chapter09 {

/// Cubes of 0.5 m and 20 kg exactly edge on edge, on a block of the same size that stands still, all turned
/// together by some angle so that coordinates are rounded. Each falls through the same gap [m].
/// @param turned  angle [rad]
World tower(int cubes, double turned, double gap);

}  // namespace enduring::chapter09
