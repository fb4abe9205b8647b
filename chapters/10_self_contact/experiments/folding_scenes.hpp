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

}  // namespace enduring::chapter10
