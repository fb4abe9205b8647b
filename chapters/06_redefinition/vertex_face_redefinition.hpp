#pragma once

#include "chapters/06_redefinition/pair_projection.hpp"

#include <vector>

namespace enduring {

/// A vertex that was handed from one face to another, or left its body through one. Edges may have to be
/// handed on with it (edge_pairs_of_redefinition).
struct Redefinition {
    int body_a, vertex, body_b;
    int old_face, new_face;  ///< of body_b
    Vec3 reference_normal;   ///< n_ref: of the face whose pair is regular, out of body_b; any length
    double start = 0;        ///< part of the step from which the vertex's pair pushes
};

using Redefinitions = std::vector<Redefinition>;

/// Whether a foot beyond the face lies beyond an edge that has no other face.
/// @param weights  of the foot
bool past_border(const SurfaceTopology& surface, int face, const std::array<double, 3>& weights);

/// Follows the vertices that have been inside since an earlier step, thesis 6.2.3 with 6.2.4, from where
/// everything lies at the start of the step:
///   the foot of the vertex is on its face      the pair stays and acts at the foot
///   it is not                                  algorithm 6.1, the faces around the corners it went to
///   the pair is hooked                         the faces around all corners; without a regular one, held
///   it is past an open border                  resolved: a sheet has no inside beyond its rim
/// A pair whose depth is positive after this is resolved (thesis 5.2.1); before, the depth would be that of a
/// face that the vertex no longer lies under (artefact 6.1.3).
///
/// Sets weights, faces, category, held and resolved of vertex-face
/// contacts; appends to `redefinitions` what changed.
void redefine_enduring_vertices(const World& world, Contacts& contacts, Redefinitions& redefinitions);

/// Hands a new hooked pair on before its first impulse (thesis 6.2.4). At the start of the step its vertex is
/// still outside, so the faces are judged by where it is going to be at the end. Held if none of them makes a
/// regular pair: an impulse would push along the vertex's own surface.
void redefine_hooked_entry(const World& world, Contact& contact, Redefinitions& redefinitions);

}  // namespace enduring
