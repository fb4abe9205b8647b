#pragma once

#include "common/geometry/vector.hpp"

#include <array>
#include <cmath>
#include <optional>

namespace enduring {

//! [triangle_foot]
/// A point dropped at right angles onto the plane of a triangle.
struct TriangleFoot {
    /// barycentric, with sum 1; a negative one says beyond which side the foot lies
    std::array<double, 3> weights;
    double depth;  ///< of the point along the triangle's unit normal [m], negative below it
};

/// None for a triangle a, b, c without area.
inline std::optional<TriangleFoot> foot_on_triangle(const Vec3& point, const Vec3& a, const Vec3& b,
                                                    const Vec3& c)
{
    const Vec3 side_1 = b - a, side_2 = c - a, normal = side_1.cross(side_2), offset = point - a;
    const double squared_length = normal.squaredNorm();
    if (!(squared_length > 0))
        return std::nullopt;
    const double w1 = offset.cross(side_2).dot(normal) / squared_length;
    const double w2 = side_1.cross(offset).dot(normal) / squared_length;
    return TriangleFoot{{1 - w1 - w2, w1, w2}, normal.dot(offset) / std::sqrt(squared_length)};
}
//! [triangle_foot]

}  // namespace enduring
