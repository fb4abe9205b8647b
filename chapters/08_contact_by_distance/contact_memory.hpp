#pragma once

#include "common/simulation/step.hpp"

namespace enduring {

//! [what]
/// What lasts of a pair from step to step is its load, its stiffness, its rest offset, and its stretch and
/// slip along the surface. It belongs to the key of the pair: its kind, its bodies, its features. Where a
/// vertex comes to another face of the same body that faces the same way, the new pair takes over what its
/// spring held.
//! [what]

/// Gives pairs that geometry found what those of the last step remember.
/// @param last  pairs of the last step
void remember(const World& world, const Contacts& last, Contacts& found);

}  // namespace enduring
