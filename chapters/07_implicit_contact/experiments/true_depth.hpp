#pragma once

#include "common/simulation/step.hpp"

namespace enduring::chapter07 {

/// How far bodies are inside each other and below planes [m]. It knows nothing of pairs: of each surface it
/// takes the vertices, and the middles of what its edges have inside another one, and asks of each point
/// whether a closed surface winds around it, and how far its nearest face is. An edge that passes an open
/// surface counts as deep as the nearer one of its ends lies behind the face, or where it goes on beyond the
/// border.
///
/// It looks at all features of bodies whose boxes overlap, so it serves checks, not solvers.
double true_depth(const World& world);
/// The same for one body against one other, of the first one's vertices and edges.
double true_depth(const Body& a, const Body& b);

}  // namespace enduring::chapter07
