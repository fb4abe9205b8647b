#pragma once

#include "common/render/stage.hpp"

#include <vector>

namespace enduring {

/// One corner as the graphics library reads it. Single precision is enough here: positions are taken relative to the
/// stage's centre, and nothing that is drawn flows back into a computation.
struct Corner {
    Eigen::Vector3f position, normal, color;
    Eigen::Vector3f barycentric;  ///< 1 at this corner, for lines along the edges
};

/// Three corners a triangle, in a row.
using TriangleSoup = std::vector<Corner>;

/// Flat normals, or with `smooth` their blend over the faces around each vertex that are less than 40 degrees apart.
void add_surface(TriangleSoup& soup, const Drawable& body, const Vec3& centre);

/// A ball, a rod (with a head, or in dashes) and a coloured triangle; their size follows from the camera and the height
/// of the picture [px].
void add_dot(TriangleSoup& soup, const Dot& dot, const Camera& camera, int height, const Vec3& centre);
void add_segment(TriangleSoup& soup, const Segment& segment, const Camera& camera, int height, const Vec3& centre);
void add_triangle(TriangleSoup& soup, const TintedTriangle& triangle, const Vec3& centre);

}  // namespace enduring
