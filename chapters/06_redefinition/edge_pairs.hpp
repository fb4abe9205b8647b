#pragma once

#include "chapters/06_redefinition/pair_projection.hpp"
#include "chapters/06_redefinition/vertex_face_redefinition.hpp"

namespace enduring {

/// eps_E, thesis 6.2.3: so far beyond an end, as a part of the edge's length, an edge pair is kept in mind.
inline constexpr double edge_tolerance = 0.3;

/// Below this sine of their angle (about 6 degrees) two edges say nothing of which way is out.
inline constexpr double smallest_edge_sine = 0.1;

/// Follows the edge pairs that endure, thesis 6.2.3, from where everything lies at the start of the step:
///   both feet on their edges                the pair stays and acts at them
///   a foot in the tolerance beyond an end   held: it takes no impulse, and is there when it comes back
///   farther out                             dismissed
/// A hooked pair is held, and so is one whose edges have become
/// parallel. One whose depth is positive is resolved.
///
/// The thesis dismisses at the end of the step in one place and before the impulses in another. Before the
/// impulses is right: they are the first to need the weights, and nothing moves between the two.
///
/// Sets weights, category, held and resolved of edge-edge contacts; a dismissed one counts as resolved.
void dismiss_enduring_edges(const World& world, Contacts& contacts);

/// When a vertex passes from one face to another, the edges at it pass over the edges between: pairs that
/// never cross from outside, and that no detection finds (thesis 6.2.3). Appends each pair of an edge at the
/// vertex (L_A) and an edge at the vertices that both faces have (L_B) which is inside, overlaps within
/// `edge_tolerance` (held if only within that), is regular, and is not in the list yet.
///
/// The redefinition's reference normal, which the thesis names and does not use, orients it, and judges it as
/// well: a pair whose normal stands at more than 45 degrees to it is not taken. Two edges alone cannot tell a
/// shallow contact from a deep one (thesis 6.2.2, which asks for the neighbours' normals at this point).
///
/// A vertex that leaves its body needs the same, which the thesis does not say: a trailing edge that passes
/// over a vertex of the floor leaves the floor's edges behind the vertex for those before it.
///
/// @param tau  moment of the step at which positions are looked at
void append_edge_pairs(const World& world, const Redefinitions& redefinitions, double tau,
                       Contacts& contacts);

}  // namespace enduring
