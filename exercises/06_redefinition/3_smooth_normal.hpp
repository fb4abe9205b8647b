#pragma once

#include "chapters/05_categorisation/normal_span.hpp"

#include <array>
#include <span>

namespace enduring {

/// The normal of a vertex: the mean of its faces' unit normals, each with
/// the angle that the face has at the vertex. A face without area says nothing.
/// @return  unit length
Vec3 vertex_normal(const SurfaceMoment& surface, int vertex);

/// A normal that changes smoothly over a face and goes over into its neighbours without a leap: the vertices'
/// normals, mixed by the barycentric weights of the point.
/// @param weights  of the point on the face, summing to 1
/// @return         unit length
Vec3 smooth_normal(const SurfaceMoment& surface, int face, const std::array<double, 3>& weights);

/// The largest angle between a normal and the next along a path.
/// @param normals  unit vectors, in the order of the path
/// @return         angle [rad]; 0 for fewer than two
double largest_leap(std::span<const Vec3> normals);

}  // namespace enduring
