#pragma once

#include "common/experiments/render/stage.hpp"
#include "common/experiments/render/triangle_soup.hpp"

namespace enduring {

/// A ball, a rod (with a head, or in dashes) and a coloured triangle; their size follows from the camera and
/// the height of the picture [px].
void add_dot(TriangleSoup& soup, const Dot& dot, const Camera& camera, int height, const Vec3& centre);
void add_segment(TriangleSoup& soup, const Segment& segment, const Camera& camera, int height,
                 const Vec3& centre);
void add_triangle(TriangleSoup& soup, const TintedTriangle& triangle, const Vec3& centre);

}  // namespace enduring
