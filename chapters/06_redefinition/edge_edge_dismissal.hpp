#pragma once

#include "chapters/06_redefinition/pair_projection.hpp"

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

}  // namespace enduring
