#pragma once

#include "chapters/06_redefinition/vertex_face_redefinition.hpp"

namespace enduring {

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
