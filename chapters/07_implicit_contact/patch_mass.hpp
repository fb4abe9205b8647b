#pragma once

#include "chapters/07_implicit_contact/step_problem.hpp"

namespace enduring {

/// The mass that each pair of a step stands for while all pairs between its two bodies, its patch, press
/// alike: 1 / (n . W sum of n), W the change of its velocity per impulses of all [kg]. It is at most the mass
/// that the pair feels alone; a rigid body's masses add up to its own. The order is that of the rows.
std::vector<double> patch_masses(const StepProblem& step);

/// Gives the pairs of a step their stiffness where the wanted depth is a goal: on its patch's mass the weight
/// presses each as deep as wanted, and so does a larger load.
/// @param first  as set_up() has it: enduring pairs get their stiffness once a step
void aim_at_wanted_depth(const World& world, StepProblem& step, const StiffnessChoice& choice,
                         double most_load, bool first);

}  // namespace enduring
