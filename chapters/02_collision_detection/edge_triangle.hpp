#pragma once

#include "common/geometry/vector.hpp"

#include <optional>

namespace enduring {

/// Where an edge passes through a triangle: p + along_edge (q - p) = (1 -
/// weight_b - weight_c) a + weight_b b + weight_c c.
struct EdgeTriangleHit {
    double along_edge, weight_b, weight_c;
};

/// Discrete test at one moment: does the edge pq pass through the
/// triangle abc? Solves (4.4) by Cramer's rule.
///
/// Edges parallel to the triangle's plane count as missing it, and answers within rounding of the triangle's
/// border may go either way: this is the test as it is taught. The solver uses the certified query.
/// @see thesis (4.1)-(4.4); its condition "all three in [0, 1]" lacks weight_b + weight_c <= 1 and so accepts
///      the whole parallelogram over b - a and c - a
std::optional<EdgeTriangleHit> find_edge_triangle_hit(const Vec3& p, const Vec3& q, const Vec3& a,
                                                      const Vec3& b, const Vec3& c);

}  // namespace enduring
