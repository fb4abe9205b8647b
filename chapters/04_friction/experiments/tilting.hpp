#pragma once

#include "common/scenes/scene.hpp"

namespace enduring::chapter04 {

/// The angle [degrees] at which a box of 1 m x `height` x 1 m on a ramp moves faster than 1 cm/s, when the
/// ramp starts level and tilts by 0.2 degrees a second.
double sliding_angle(double height, double dt, const FrictionParameters& friction);

}  // namespace enduring::chapter04
