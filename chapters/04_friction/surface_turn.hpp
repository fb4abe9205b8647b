#pragma once

#include "common/simulation/contact.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// How the surface that a pair holds on to turns, from the pair's start to the end of the step.
///
/// It is measured on the pair's own features, so it serves all kinds of bodies alike. Its axes are the normal
/// and the bisector of the two sides: those of the face, or both edges, of which neither counts more than the
/// other. A plane does not turn, and features without a normal have no axes: for them it is the identity.
Mat3 surface_turn(const World& world, const Contact& contact);

/// How far p moves against q from the pair's start to the end of the step, as seen from a surface that turns:
/// two points of matter that turn with it do not move at all [m].
/// @param turn  surface_turn() of the contact
Vec3 motion_on_surface(const World& world, const Contact& contact, const Mat3& turn);

}  // namespace enduring
