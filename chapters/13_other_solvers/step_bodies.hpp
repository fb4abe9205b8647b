#pragma once

#include "chapters/13_other_solvers/method_solver.hpp"

namespace enduring {

/// The bodies of a world as the methods see them when a step begins, and the ground behind them; no points
/// yet.
/// @param dt  [s]
/// @throws InputError  a body that the method cannot move; names it and why
MethodStep step_bodies(const World& world, double dt, SoftBodies soft);

/// A pair of the search among these bodies.
ContactPoint contact_point(const World& world, const MethodStep& step, const Contact& contact,
                           const FrictionCoefficients& friction);

}  // namespace enduring
