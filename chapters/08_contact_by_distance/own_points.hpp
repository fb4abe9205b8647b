#pragma once

#include "common/simulation/step.hpp"

namespace enduring {

//! [own_points]
/// Moves the points of a pair, which were found on surfaces for contact, to the bodies' own: p stays on its
/// feature, and q comes to lie below it along the normal, on the face or the edge that was nearest. So both
/// points are at one place where the bodies touch, and push and counter-push have one line. An impulse acts
/// on a soft body with the lever that its nodes have when the step begins, whenever in the step it meets the
/// other. So two soft bodies get their points there, and lose no angular momentum to each other.
/// @param tau  moment of the step, in [0, 1]; for bodies of which one keeps its shape
void put_on_own_surfaces(const World& world, double tau, Contact& contact);
//! [own_points]

}  // namespace enduring
