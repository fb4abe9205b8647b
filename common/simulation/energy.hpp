#pragma once

#include "common/simulation/contact_parameters.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// What all bodies carry together, without what the springs of contacts hold.
Energy total_energy(const World& world);

/// What the springs of friction hold at the end of a step [J].
double friction_spring_energy(const Contacts& contacts, const FrictionParameters& friction);

/// What the springs of those pairs hold at the end of a step that were given their own stiffness [J]: along
/// the normal by the load that they carry, along the surface by their stretch.
double spring_energy(const Contacts& contacts);

}  // namespace enduring
