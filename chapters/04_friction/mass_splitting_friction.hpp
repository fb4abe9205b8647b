#pragma once

#include "chapters/04_friction/friction_law.hpp"
#include "chapters/04_friction/shared_mass.hpp"
#include "common/simulation/contact.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// Mass-splitting friction for all pairs that push now: their springs first, then at most
/// 30 rounds of better_impulse(), in each of which every pair sees what all of them did
/// before. Writes friction and slip; nothing is applied.
void mass_splitting_friction(const World& world, Contacts& contacts, const MassSplitting& friction,
                             double dt);

}  // namespace enduring
