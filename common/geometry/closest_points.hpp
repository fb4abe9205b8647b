#pragma once

#include "common/geometry/vector.hpp"

#include <array>
#include <optional>

namespace enduring {

/// The point of a triangle that is nearest to another point.
struct ClosestOnTriangle {
    std::array<double, 3>
        weights;      ///< of its corners, with sum 1; exactly 0 for those of which the point is no mean
    Vec3 point;       ///< [m]
    double distance;  ///< [m]
};

/// A triangle without area is a segment or a point.
/// @see Ericson 2005, "Real-time collision detection", section 5.1.5: in which of the seven regions around a
///     triangle a point lies
ClosestOnTriangle closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

/// The points of two segments that are nearest to each other, where both are inside.
struct ClosestOnEdges {
    double s, t;      ///< in (0, 1), along the first segment and along the second
    Vec3 difference;  ///< from the point of the second to that of the first [m]
};

/// @param least_sine  of the angle of the two: below, nearly parallel ones have no points that are nearest
/// @return            none if one of the nearest points of the two lines is no inner point of its segment
std::optional<ClosestOnEdges> closest_inside_edges(const Vec3& a0, const Vec3& a1, const Vec3& b0,
                                                   const Vec3& b1, double least_sine);

}  // namespace enduring
