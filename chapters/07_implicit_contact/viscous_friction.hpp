#pragma once

#include "chapters/07_implicit_contact/pair_law.hpp"

namespace enduring {

/// A film between two surfaces brakes them by a force against the slip u, the faster and the more heavily
/// loaded the harder:
///   f = - c N u
/// with c in s/m, so that a body's share does not depend on its number of pairs. It has no limit, and holds
/// nothing at rest. The potential c N |u|^2 / 2 is convex where N is that of an earlier motion.

/// What the film does to p in the step [N s].
/// @param velocity  of p against q [m/s]
Vec3 film_impulse(const PairLaw& pair, const Vec3& velocity);
/// Minus its derivative [kg].
Mat3 film_hessian(const PairLaw& pair);

/// The stretch with which a pair's friction begins a step: that of the last force, which has the film's part
/// in it, and no more than its spring can hold [m].
/// @param most  force of that spring, over its stiffness [m]
Vec3 stretch_without_film(const Vec3& stretch, double most);

}  // namespace enduring
