#pragma once

#include "chapters/04_friction/tangent_plane.hpp"

namespace enduring {

/// A surface with a grain, as brushed metal or wood: rubbing along it is easier
/// than across it. What it can hold is an ellipse.
struct Grain {
    Vec2 direction;    ///< of the grain, in the tangent plane, unit length
    double mu_along;   ///< coefficient of friction along the grain, positive
    double mu_across;  ///< and across it, positive
};

/// Can friction hold this impulse? The ellipse's edge still holds.
/// @param wanted          what would stop the pair [N s]
/// @param normal_impulse  |I_n| [N s], positive
bool holds(const Grain& grain, const Vec2& wanted, double normal_impulse);

/// The friction impulse on a pair that slips: of all that the ellipse
/// allows, the one that takes the most energy.
/// @param velocity  of the slip [m/s]
/// @return          impulse [N s]; zero without slip
Vec2 sliding_impulse(const Grain& grain, const Vec2& velocity, double normal_impulse);

/// Where a small block that is launched on a level floor comes to rest, by steps of symplectic Euler: new
/// velocity, then new place. The step in which friction would turn the velocity round stops it.
/// @param velocity  at the start, at (0, 0) [m/s]
/// @param gravity   g [m/s^2]
/// @param dt        length of a step [s]
/// @return          place [m]
Vec2 stopping_place(const Grain& grain, Vec2 velocity, double gravity, double dt);

}  // namespace enduring
