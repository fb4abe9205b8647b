#pragma once

#include "chapters/07_implicit_contact/step_problem.hpp"

namespace enduring {

/// What counts as a momentum at all: what gravity gives to all bodies of an island in a step, or if that is more, what
/// the rounding of their coordinates does [sqrt(kg) m/s].
double least_speed(const World& world, const Island& island, double dt);

/// Residual to which the convex problem of a round is solved. Its normals, its limits and its soft masses are those of the last
/// motion, so a round seldom takes away more than a thousandth of what is left on the bodies. In a jam the limits are wrong by
/// more than the convex problem is: then a tenth of its own residual is taken away.
/// @param on_bodies  with the limits that the motion makes
/// @param of_round   with those of the round, where it begins
double sharp_enough(double on_bodies, double of_round, double tolerance);

/// Residual that rounding may leave, whatever the impulses are: a spring answers the last digit of a coordinate with k dt times
/// it. A stiff spring in a short step, in which weight does little, so leaves more than a millionth.
double rounding_residual(const World& world, const StepProblem& step, double least_speed);

}  // namespace enduring
