#pragma once

#include "chapters/03_penalty_impulses/bernstein.hpp"
#include "common/geometry/vector.hpp"

#include <array>

namespace enduring {

using PairVertices = std::array<Vec3, 4>;  ///< v f0 f1 f2, or a0 a1 b0 b1 [m]

//! [pair_instant]
/// A pair at one instant. A vertex-face pair and an edge-edge pair differ in these three vectors and in nothing else.
struct PairInstant {
    Vec3 side_1, side_2;  ///< the unnormalised normal is side_1 x side_2 [m]
    Vec3 offset;          ///< from any point of B's feature to any point of A's [m], see below
};

/// Both ends of a step; between them every vertex, and so each of the three vectors, moves along a straight line.
struct PairStep {
    PairInstant t0, t1;
};

// The depth n . (p - q) needs no weights: p and q leave the vertices below along the sides, and n is at right angles
// to both. The weights say where the impulse goes, not how large it is.

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

//! [contact_normal]
/// The unnormalised contact normal over the step [m^2]: n0, n1, n2 of thesis (5.12) and (5.18).
///
/// A product of two straight motions is quadratic, so nothing is lost.
inline Bernstein<Vec3, 2> contact_normal(const PairStep& step)
{
    const Vec3 n0 = step.t0.side_1.cross(step.t0.side_2);
    const Vec3 n2 = step.t1.side_1.cross(step.t1.side_2);
    const Vec3 turn = (step.t1.side_1 - step.t0.side_1).cross(step.t1.side_2 - step.t0.side_2);
    return {{n0, 0.5 * (n0 + n2 - turn), n2}};
}

/// The penetration depth times the normal's length over the step [m^3]: n(tau) . (p - q)(tau), thesis (5.6); negative
/// inside. Quadratic times linear: a cubic, the same one whose roots are the times of coplanarity in chapter 2.
inline Bernstein<double, 3> penetration_depth(const Bernstein<Vec3, 2>& normal, const PairStep& step)
{
    const auto& [n0, n1, n2] = normal.coefficients;
    const Vec3 &d0 = step.t0.offset, &d1 = step.t1.offset;
    return {{n0.dot(d0), (2 * n1.dot(d0) + n0.dot(d1)) / 3, (n2.dot(d0) + 2 * n1.dot(d1)) / 3, n2.dot(d1)}};
}
//! [contact_normal]

//! [squared_length]
/// The squared length of the normal over the step [m^4]: the L_i of thesis (5.13), corrected to a sum (see the errata).
inline Bernstein<double, 4> squared_length(const Bernstein<Vec3, 2>& normal)
{
    const auto& [n0, n1, n2] = normal.coefficients;
    return {{n0.dot(n0), n0.dot(n1), (2 * n1.dot(n1) + n0.dot(n2)) / 3, n1.dot(n2), n2.dot(n2)}};
}

/// L_k^2, thesis (5.14): the mean of the L_i, which is the mean of the squared length over the step [m^4].
inline double mean_squared_length(const Bernstein<Vec3, 2>& normal)
{
    const auto [L0, L1, L2, L3, L4] = squared_length(normal).coefficients;
    return (L0 + L1 + L2 + L3 + L4) / 5;
}
//! [squared_length]

}  // namespace enduring
