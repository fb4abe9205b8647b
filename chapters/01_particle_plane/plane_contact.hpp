#pragma once

#include "common/simulation/step.hpp"

namespace enduring {

/// Detection: appends a contact for every vertex of a moving body that is below a plane at some time of the
/// step and has no contact with it yet. Its start is where the vertex goes under.
void detect_plane_contacts(World& world, Contacts& contacts);

/// Resolution: removes the plane contacts whose vertex stands outside at the start of the step, that is, left
/// the ground in the step before.
void resolve_plane_contacts(World& world, Contacts& contacts);

}  // namespace enduring
