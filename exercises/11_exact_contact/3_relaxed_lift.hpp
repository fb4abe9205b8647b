#pragma once

#include "common/geometry/vector.hpp"

namespace enduring {

/// A block of 1 kg above the ground.
struct BlockOverGround {
    double gap;     ///< [m]
    double rising;  ///< [m/s]
    double speed;   ///< along the ground [m/s]
};

/// The impulse that a block gets from the ground under the convex relaxation [N s]: among all impulses of the
/// cone |r_t| <= mu r_n, the one that leaves the least kinetic energy m/2 |q + r/m|^2. The first number is
/// along the normal.
/// @param free_velocity  q: without contact [m/s]
Vec3 relaxed_impulse(const Vec3& free_velocity, double mass, double mu);

/// The velocity of the block along the normal after this impulse [m/s].
double rising_speed(const Vec3& free_velocity, double mass, double mu);

/// The gap after a step under gravity of 9.81 m/s^2 [m]. The relaxed rule holds for the velocity with the gap
/// divided by dt added along the normal. So a small gap has an effect, and a large gap has none.
double gap_after(const BlockOverGround& block, double mu, double dt);

/// The gap after a step in which the contact pushes and the block ends with this speed [m].
double floating_gap(double speed, double mu, double dt);

}  // namespace enduring
