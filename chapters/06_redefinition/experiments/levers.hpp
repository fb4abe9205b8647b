#pragma once

#include "common/geometry/vector.hpp"

namespace enduring::chapter06 {

/// What two free blocks gain in angular momentum together, over a collision in which one slides along the
/// other [kg m^2/s], and what the same impulses would give them with other levers.
struct LeverCost {
    Vec3 measured = Vec3::Zero();  ///< from the bodies
    Vec3 at_start = Vec3::Zero();  ///< the sum of (p - q) x I, with the places at the step's start
    Vec3 in_middle = Vec3::Zero();
    Vec3 at_end = Vec3::Zero();
    double pushed = 0;  ///< the sum of the impulses' lengths [N s]
};

/// A block of 20 kg comes down on one of 40 kg and slides along it, without friction and weight.
/// @param dt     [s]
/// @param speed  along it [m/s]
LeverCost cost_of_levers(double dt, double speed);

}  // namespace enduring::chapter06
