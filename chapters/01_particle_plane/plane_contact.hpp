#pragma once

#include "common/simulation/contact_parameters.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// Detection: appends a contact for every vertex of a moving body that is below a plane at some time of the step and
/// has no contact with it yet. Its start is where the vertex goes under.
void detect_plane_contacts(World& world, Contacts& contacts);

/// Resolution: removes the plane contacts whose vertex stands outside at the start of the step, that is, left the
/// ground in the step before.
void resolve_plane_contacts(World& world, Contacts& contacts);

/// Response: gives every waiting plane contact its impulse along the normal. All come from the same predicted positions,
/// and the step applies them together.
/// @param stiffness  k of one vertex [N/m], positive; a plane with a stiffness of its own takes that
/// @param dt         length of the step [s], positive
void push_out_of_planes(const World& world, Contacts& contacts, PenaltyMethod method, double stiffness, double dt);

}  // namespace enduring
