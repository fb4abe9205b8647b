#pragma once

#include "common/simulation/contact_parameters.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// This chapter's solver: chapter 1 for planes, and a list of all features of two bodies that meet. Nothing
/// answers them: they are held. It keeps the trees of one world, so make one for each run.
Solver chapter02_solver(const ContactParameters& parameters);

}  // namespace enduring
