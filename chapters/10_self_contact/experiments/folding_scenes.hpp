#pragma once

#include "chapters/10_self_contact/experiments/soft_runs.hpp"

namespace enduring::chapter10 {

/// 40 cm of a strip of 2 cm fall on their end.
SoftRun falling_strip(const SoftVariant& variant);

/// Two spirals fly into each other, weightless.
SoftRun spirals(const SoftVariant& variant);

/// A board falls on a ring that stands on the ground.
SoftRun squashed_ring(const SoftVariant& variant);

/// A bunny's ears are pulled down to its back and let go. It is weightless, and its feet are held.
SoftRun pressed_ears(const SoftVariant& variant);

/// A hairpin whose ends nearly touch falls freely.
SoftRun falling_hairpin(double gap, double dt);

/// What its pairs with itself have done after some steps.
struct HairpinFall {
    double pushed = 0;    ///< sum of all impulses, over its weight for the time of the run [1]
    double off_fall = 0;  ///< of a vertex from what a free body does, over the body's size, the most [1]
};
HairpinFall run_hairpin(double gap, double dt, int steps);

}  // namespace enduring::chapter10
