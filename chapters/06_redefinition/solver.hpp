#pragma once

#include "common/simulation/contact_parameters.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// The course's last solver: chapter 5's, and pairs of features that follow the motion (thesis 6). A vertex
/// that is inside a body has exactly one pair with it; what pushes is regular, acts where the features are
/// now, and ends when they part. It keeps the trees of one world, so make one for each run.
Solver chapter06_solver(const ContactParameters& parameters);

}  // namespace enduring
