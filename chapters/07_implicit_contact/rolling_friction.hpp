#pragma once

#include "chapters/07_implicit_contact/step_problem.hpp"

namespace enduring {

/// A pair of rigid bodies that press each other on a patch resists their turns against each other, too:
///   rolling about an axis along the surface, by a torque of at most  (rolling) N,
///   spinning about the normal, by at most  2/3 mu (patch) N,  that of a round patch with equal pressure.
/// Each is a row of turns behind those of pairs, with the load of its pair. A soft body has no such row: its
/// patch is made of pairs itself.

//! [rolling_choice]
struct RollingChoice {
    /// h = k dt^2 / I of a pair that holds a turn. It creeps with 1 / h of the speed that a torque would give
    /// it in a step. A hundredth: a ball of a metre creeps by 0.1 mm in a second. A hundred times: rounding
    /// of velocities is all that is left of it.
    double k_dt2_over_inertia = 1e6;
};
inline constexpr RollingChoice rolling_choice;
//! [rolling_choice]

/// Appends the rows of all pairs that have one.
/// @param friction  of pairs without a material
void add_rolling_rows(const World& world, const FrictionCoefficients& friction, StepProblem& step);

/// Brings these rows to the motion and the loads of the last round.
void follow_rolling(const World& world, const FrictionCoefficients& friction, StepProblem& step);

}  // namespace enduring
