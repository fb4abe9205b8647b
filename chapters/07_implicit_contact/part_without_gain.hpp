#pragma once

#include "chapters/07_implicit_contact/step_problem.hpp"

namespace enduring {

/// The largest part, up to 1, of the impulses that act in an island, with which its pairs give no more energy
/// than their springs held at the start of the step. What bodies that move as given and surfaces that run do
/// through the pairs is not the pairs'. Solved, the equation of a step takes energy, but for normals that
/// turn; what is not solved may give any.
double part_without_gain(const World& world, const StepProblem& step);

}  // namespace enduring
