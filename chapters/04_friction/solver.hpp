#pragma once

#include "common/simulation/contact_parameters.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// This chapter's solver: chapter 3 and friction. It keeps the trees of one world, so make one for each run.
Solver chapter04_solver(const ContactParameters& parameters);

}  // namespace enduring
