#pragma once

#include "common/simulation/step.hpp"

#include <span>

namespace enduring {

/// How deep a pair can be that no query has found, but that was made of another one [m]: no deeper than ten
/// times the deepest pair that pushes one of its two bodies, for the body may lean, and as far as its own two
/// points move towards each other or past each other in this step. What seems deeper is the distance to another
/// side of the body.
/// @param others  pairs there are; `contact` may be one of them, and counts only if it pushes
double plausible_depth(const World& world, std::span<const Contact> others, const Contact& contact);

/// Drops pairs that are deeper than that.
/// @param first  index of the first one that is asked; those before are the others
/// @param tau    moment of the step at which positions are looked at
void drop_implausible(const World& world, Contacts& contacts, std::size_t first, double tau);

}  // namespace enduring
