#pragma once

#include "common/simulation/contact_parameters.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// This chapter's solver: chapter 1 for planes, chapter 2 to find crossings, and impulses for pairs of
/// features. It keeps the trees of one world, so make one for each run.
Solver chapter03_solver(const ContactParameters& parameters);

}  // namespace enduring
