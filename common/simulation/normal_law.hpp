#pragma once

#include "common/geometry/vector.hpp"

#include <array>
#include <functional>
#include <optional>

namespace enduring {

using PairVertices = std::array<Vec3, 4>;  ///< v f0 f1 f2, or a0 a1 b0 b1 [m]

//! [pair_instant]
/// A pair at one instant. A vertex-face pair and an edge-edge pair differ
/// in these three vectors and in nothing else.
struct PairInstant {
    Vec3 side_1, side_2;  ///< the unnormalised normal is side_1 x side_2 [m]
    Vec3 offset;          ///< from any point of B's feature to any point of A's [m], see below
};

/// Both ends of a step; between them every vertex, and so each of the three vectors, moves along a straight
/// line. A vertex and a plane are a pair whose sides stand still.
struct PairStep {
    PairInstant t0, t1;
    /// of a plane, unit length: the exact one, which side_1 x side_2 rounds
    std::optional<Vec3> plane_normal{};
};

// The depth n . (p - q) needs no weights: p and q leave the vertices below along the sides, and n is at right
// angles to both. The weights say where the impulse goes, not how large it is.

/// @param x  v f0 f1 f2, the face counter-clockwise seen from outside
inline PairInstant vertex_face_instant(const PairVertices& x)
{
    return {x[2] - x[1], x[3] - x[1], x[0] - x[1]};
}

/// @param x            a0 a1 b0 b1
/// @param orientation  1 or -1: the sign that made (a1-a0) x (b1-b0) point from B to A at first contact
inline PairInstant edge_edge_instant(const PairVertices& x, double orientation)
{
    return {orientation * (x[1] - x[0]), x[3] - x[2], x[0] - x[2]};
}
//! [pair_instant]

/// What a pair's motion over one step makes of its stiffness: the impulse on p
/// [N s]. Vertex i receives its weight times it.
///
/// @param step   both ends of the step, as predicted
/// @param start  from where the pair counts, in [0, 1]: its time of impact, or 0 when it endures
/// @param k      stiffness of the pair [N/m], positive; a plane may have its own
/// @param dt     length of the step [s], positive
using NormalLaw = std::function<Vec3(const PairStep& step, double start, double k, double dt)>;

}  // namespace enduring
