#pragma once

#include "chapters/07_implicit_contact/step_problem.hpp"

namespace enduring {

/// The mass that each pair stops in this step [kg]: its impulse over the fastest approach of any pair, without all
/// pairs' impulses, and at least over what gravity gives in a step. It is more than the mass that the pair feels itself where other bodies press through its own.
std::vector<double> pressing_masses(const World& world, const StepProblem& step);

/// Makes pairs as stiff at once as the mass that presses them asks for, where this is more than twice what they
/// are, but no stiffer than their load asks for; no force changes.
/// @param step  as it is solved
/// @return      whether there was any: then the step's problem is another one
bool stiffen_where_pressed(const World& world, StepProblem& step, const StiffnessChoice& choice);

}  // namespace enduring
