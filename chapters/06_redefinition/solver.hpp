#pragma once

#include "chapters/03_penalty_impulses/crossing_detection.hpp"
#include "common/simulation/contact_parameters.hpp"
#include "common/simulation/step.hpp"

#include <memory>

namespace enduring {

/// The course's last solver: chapter 5's, and pairs of features that follow the motion (thesis 6). A vertex
/// that is inside a body has exactly one pair with it; what pushes is regular, acts where the features are
/// now, and ends when they part. It keeps the trees of one world, so make one for each run.
Solver chapter06_solver(const ContactParameters& parameters);
/// The same with another search for pairs.
Solver chapter06_solver_with(const ContactParameters& parameters,
                             std::unique_ptr<CrossingDetection> detection);

}  // namespace enduring
