#pragma once

#include "chapters/02_collision_detection/query.hpp"

#include <array>

namespace enduring {

/// Where on the face the vertex is at time tau: weights of f0, f1, f2, in [0, 1] with
/// sum 1, of the face's point closest to the vertex. At an impact that is the contact
/// point, also where the face is a sliver or has collapsed.
/// @param tau  in [0, 1], e.g. a time of impact
std::array<double, 3> impact_weights(const VertexFaceStep& step, double tau);

/// Where the edges are closest at time tau: {s, t} in [0, 1] for the points (1-s) ea0 + s ea1 and (1-t) eb0 +
/// t eb1. Parallel edges have many closest points; one of them is returned.
std::array<double, 2> impact_weights(const EdgeEdgeStep& step, double tau);

}  // namespace enduring
