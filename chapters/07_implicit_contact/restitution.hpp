#pragma once

#include "chapters/07_implicit_contact/islands.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// Behind the commit: pairs that met in this step send their bodies back, as the coefficients of restitution of the world say.
/// Only velocities change, by impulses of pairs that carried one in this step: along their normals, and friction of these. Without coefficients nothing is done.
/// @param friction  of all pairs; a world's materials come before it
void restitute(World& world, Contacts& contacts, const FrictionCoefficients& friction, double dt);

}  // namespace enduring
