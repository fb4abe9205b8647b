#pragma once

#include "common/geometry/vector.hpp"

namespace enduring {

/// The point of the cone |r_t| <= mu r_n that is nearest to an impulse. The first number is along the normal
/// [N s].
Vec3 nearest_point(const Vec3& impulse, double mu);

/// r - P(r - u~) of one contact, where u~ is the velocity with mu |u_t| added along the normal. Zero if and
/// only if the contact is exact.
Vec3 map_of_contact(const Vec3& impulse, const Vec3& velocity, double mu);

/// The impulse that a block of this mass gets from the ground [N s], by cases: the block flies, holds or
/// slides. Its velocity after the step is free_velocity + impulse / mass.
Vec3 impulse_on_block(const Vec3& free_velocity, double mass, double mu);

/// The number of passes after which the velocity of a block that holds is at most `part` of its free
/// velocity, with remembered forces and springs of this h = k dt^2 / m. The first solve is a pass. `part` is
/// above 0 and below 1.
int passes_needed(double h, double part);

}  // namespace enduring
