#pragma once

#include "common/simulation/contact_parameters.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// This chapter's solver: vertices against the scene's planes, and nothing else.
Solver chapter01_solver(const ContactParameters& parameters);

}  // namespace enduring
