#pragma once

#include "chapters/02_collision_detection/query.hpp"

namespace enduring {

/// Distance of a point from a triangle: from the nearest of all its points.
/// @return [m]
double distance_to_triangle(const Vec3& point, const Vec3& f0, const Vec3& f1, const Vec3& f2);

/// A bound on how fast the distance of vertex and face can shrink over the step: how far the vertex goes plus
/// how far the fastest corner goes. Exact enough to be safe; it makes no use of directions.
/// @return [m] per step
double fastest_approach(const VertexFaceStep& step);

/// Conservative advancement: a time up to which vertex and face certainly stay farther apart than a gap, and
/// close before which they come that near.
///
/// @param gap      distance to be kept [m], positive
/// @param close    how near the distance may come to the gap before the search stops [m], positive
/// @return         tau in [0, 1): the distance there is at most gap + close, and before it
///                 is more than gap; nothing if it stays so until the end of the step. 0
///                 when they begin nearer than gap + close.
std::optional<double> conservative_time(const VertexFaceStep& step, double gap, double close);

}  // namespace enduring
