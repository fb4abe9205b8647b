#pragma once

#include "common/geometry/vector.hpp"

#include <optional>

namespace enduring {

//! [steps]
/// A vertex and a face over one step: every point moves on a straight line from its place at the start
/// (`_t0`) to its place at the end (`_t1`), while tau runs from 0 to 1. All coordinates [m], finite.
struct VertexFaceStep {
    Vec3 v_t0, f0_t0, f1_t0, f2_t0;
    Vec3 v_t1, f0_t1, f1_t1, f2_t1;
};

/// Two edges, ea0-ea1 and eb0-eb1, over one step; points move as in VertexFaceStep.
struct EdgeEdgeStep {
    Vec3 ea0_t0, ea1_t0, eb0_t0, eb1_t0;
    Vec3 ea0_t1, ea1_t1, eb0_t1, eb1_t1;
};
//! [steps]

/// Where a point that goes straight from `start` to `end` is at time tau in [0, 1]. With the difference, as
/// the textbook's polynomials have it; lerp() rounds otherwise.
inline Vec3 at_time(const Vec3& start, const Vec3& end, double tau) { return start + tau * (end - start); }

}  // namespace enduring
