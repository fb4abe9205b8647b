#pragma once

#include "chapters/03_penalty_impulses/contact_normal.hpp"
#include "common/simulation/contact_parameters.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// The instants of a contact of kind vertex_face or edge_edge at both ends of the step, from its bodies' positions.
PairStep pair_step(const World& world, const Contact& contact);

/// Resolution: removes the pairs of features whose depth is positive at the start of the step (thesis 5.2.1).
void resolve_separated_pairs(const World& world, Contacts& contacts);

/// Response: gives every waiting pair of features its impulse along the normal. All come from the same predicted
/// positions, and the step applies them together.
/// @param stiffness  k of one pair [N/m], positive
/// @param dt         length of the step [s], positive
void push_pairs_apart(const World& world, Contacts& contacts, PenaltyMethod method, double stiffness, double dt);

}  // namespace enduring
