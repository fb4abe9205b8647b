#pragma once

#include "chapters/10_self_contact/experiments/soft_runs.hpp"

namespace enduring::chapter10 {

/// So long [s] the ends of the knot are pulled hard, and then less.
inline constexpr double knot_pulled = 1.5, knot_eased = 1.5;

/// A loose overhand knot in a rope of 1 cm, weightless, whose ends are pulled apart.
/// @param force  on each end [N], later 0.4 of it
SoftRun pulled_knot(double mu, double force);

/// From end to end of its rope [m].
double knot_span(const SoftRun& run, const World& world);

}  // namespace enduring::chapter10
