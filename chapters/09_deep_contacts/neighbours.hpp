#pragma once

#include "common/simulation/contact.hpp"
#include "common/simulation/step.hpp"

#include <optional>
#include <vector>

namespace enduring {

/// In which direction the vertices around a vertex are pushed out of a body: the mean of the normals of the
/// neighbours' regular pairs that push already. None if no neighbour is pushed, or the normals cancel.
///
/// A neighbour shares an edge with the vertex. A pair pushes already if it endures or was answered in an
/// earlier round of the step.
/// @param contact  vertex-face
/// @param tau      moment of the step at which positions are looked at
/// @return         unit length, out of body_b
std::optional<Vec3> direction_of_neighbours(const World& world, const Contacts& contacts,
                                            const Contact& contact, double tau);

/// Before new pairs are admitted: one that looks hooked counts as regular if its normal stands within 45
/// degrees of the direction of its neighbours. The vertex is one of those that came in with them.
void vouch_for_new_pairs(const World& world, Contacts& contacts);

/// A pair that only its neighbours call regular, and their direction (unit length, out of body_b).
struct VouchedPair {
    Contact contact;
    Vec3 direction;
};

/// Takes the pairs off the list that look hooked at the start of the step by their vertex' own normals, and
/// not by their neighbours' direction. What follows the others would hand them on or hold them.
std::vector<VouchedPair> take_vouched_pairs(const World& world, Contacts& contacts);

/// Follows those pairs from where everything lies at the start of the step: each stays regular and acts at
/// its foot. One whose foot has left its face goes to the best face there that looks in its neighbours'
/// direction, give or take 45 degrees. A pair whose depth is positive is resolved.
/// @param contacts  the list without them; gets them back
void follow_vouched_pairs(const World& world, const std::vector<VouchedPair>& vouched, Contacts& contacts);

}  // namespace enduring
