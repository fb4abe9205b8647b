#pragma once

#include "common/simulation/step.hpp"

namespace enduring {

//! [own_points]
/// Moves the points of a pair, which were found on surfaces for contact, to the bodies' own: p stays on its feature, and q comes to lie
/// below it along the normal, on the face or the edge that was nearest. So both points are at one place where the bodies touch, and push and
/// counter-push have one line.
/// @param tau  moment of the step, in [0, 1]
void put_on_own_surfaces(const World& world, double tau, Contact& contact);
//! [own_points]

}  // namespace enduring
