#pragma once

#include "chapters/07_implicit_contact/step_problem.hpp"
#include "chapters/12_joints/joint_laws.hpp"

namespace enduring {

/// The bodies of all joints that hold; a broken one joins nothing.
std::vector<ElementBodies> joined_bodies(const World& world);

/// Appends the rows of an island's joints. Levers and axes are those of the start of the step, so that
/// impulses take no energy.
void add_joint_rows(const World& world, StepProblem& step);

/// The velocities of these rows, and laws that go through what acts: locks and limits aim at no error where
/// the step ends as it is predicted now, by the true geometry there.
void follow_joints(const World& world, StepProblem& step);

/// What each joint's rows have pushed.
void remember_joints(World& world, const StepProblem& step);

/// All of this for chapter 7's solve.
ForceElements joint_elements();

}  // namespace enduring
