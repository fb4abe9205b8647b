#pragma once

#include "chapters/07_implicit_contact/step_problem.hpp"

namespace enduring {

//! [joint_choice]
/// How stiff a joint is while its impulse is found. It leaves nothing of it: each round takes the impulse of the last one for the
/// force that the spring begins with.
struct JointChoice {
    /// h = k dt^2 / m of each direction that is locked, with the mass that it feels. A hundredth: a heavy body on a light chain takes
    /// some times the rounds. Ten times: the rounding of coordinates is all that is left.
    double k_dt2_over_m = 1e7;
    /// The same of a motor that is not at its most: it misses its speed by this part of what its load does in a step.
    double motor = 1e7;
};
inline constexpr JointChoice joint_choice;
//! [joint_choice]

/// Rows of a joint: what it locks or limits along and about its axes, and what its springs and motors push there.
enum class JointPart : int { lock_along, lock_about, drive_along, drive_about };

/// The bodies of all joints that hold; a broken one joins nothing.
std::vector<ElementBodies> joined_bodies(const World& world);

/// Appends the rows of an island's joints. Levers and axes are those of the start of the step, so that impulses take no energy.
void add_joint_rows(const World& world, StepProblem& step);

/// The velocities of these rows, and laws that go through what acts: locks and limits aim at no error where the step ends as it is
/// predicted now, by the true geometry there.
void follow_joints(const World& world, StepProblem& step);

/// What each joint's rows have pushed.
void remember_joints(World& world, const StepProblem& step);

/// All of this for chapter 7's solve.
ForceElements joint_elements();

}  // namespace enduring
