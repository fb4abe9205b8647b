#pragma once

#include "common/simulation/step.hpp"

namespace enduring {

/// Resolution: removes the pairs of features whose depth is positive at the start of the step (thesis 5.2.1).
void resolve_separated_pairs(const World& world, Contacts& contacts);

}  // namespace enduring
