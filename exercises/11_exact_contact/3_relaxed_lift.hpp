#pragma once

#include "common/geometry/vector.hpp"

namespace enduring {

/// A block of 1 kg over the ground.
struct BlockOverGround {
    double gap;     ///< [m]
    double rising;  ///< [m/s]
    double speed;   ///< along the ground [m/s]
};

/// The impulse that a block gets from the ground under the convex relaxation: of all impulses of the cone
/// |r_t| <= mu r_n the one that leaves the least kinetic energy m/2 |q + r/m|^2. The first number is along
/// the normal [N s].
/// @param free_velocity  q: without contact [m/s]
Vec3 relaxed_impulse(const Vec3& free_velocity, double mass, double mu);

/// The velocity along the normal with which this impulse leaves the block [m/s].
double rising_speed(const Vec3& free_velocity, double mass, double mu);

/// The gap after a step under gravity of 9.81 m/s^2 [m]. The contact keeps the cone's rule for the velocity
/// over the step with the gap over dt more along the normal, so a gap that closes within the step is felt,
/// and a far one is not.
double gap_after(const BlockOverGround& block, double mu, double dt);

/// The gap at which a block that slides with this speed at the end of a step is then [m].
double floating_gap(double speed, double mu, double dt);

}  // namespace enduring
