#pragma once

#include "common/simulation/contact_parameters.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// Detection: appends a contact for every vertex of a moving body that is below a plane at some time of the
/// step and has no contact with it yet. Its start is where the vertex goes under.
void detect_plane_contacts(World& world, Contacts& contacts);

/// Resolution: removes the plane contacts whose vertex stands outside at the start of the step, that is, left
/// the ground in the step before.
void resolve_plane_contacts(World& world, Contacts& contacts);

/// This chapter's two laws, for pairs of a vertex and a plane only: what
/// they share is that the depth changes linearly.
Vec3 discrete_on_plane(const PairStep& step, double start, double k, double dt);
Vec3 continuous_on_plane(const PairStep& step, double start, double k, double dt);

/// The law that a scene asks for, on planes.
NormalLaw plane_law(const ContactParameters& parameters);

/// Response: gives every waiting contact its impulse along the normal. All come from the same predicted
/// positions, and the step applies them together.
/// @param stiffness  k of one pair [N/m], positive; a plane with a stiffness of its own takes that
/// @param dt         length of the step [s], positive
void push_apart(const World& world, Contacts& contacts, const NormalLaw& law, double stiffness, double dt);

}  // namespace enduring
