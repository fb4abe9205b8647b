#pragma once

#include "common/scenes/scene.hpp"

namespace enduring {

/// What all bodies carry together, without what the springs of contacts hold.
Energy total_energy(const World& world);

/// What the springs of friction hold at the end of a step [J].
double friction_spring_energy(const Contacts& contacts, const FrictionParameters& friction);

}  // namespace enduring
