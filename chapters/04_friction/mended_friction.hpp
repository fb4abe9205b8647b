#pragma once

#include "common/simulation/contact.hpp"
#include "common/simulation/step.hpp"
#include "friction_law.hpp"
#include "shared_mass.hpp"

namespace enduring {

/// The mended model for all pairs that push now: their springs first, then at most 30 rounds of better_impulse(), in each
/// of which every pair sees what all of them did before. Writes friction and slip; nothing is applied.
void rub_together(const World& world, Contacts& contacts, const FrictionParameters& friction, double dt);

}  // namespace enduring
