#pragma once

#include "common/geometry/meshes.hpp"

#include <vector>

namespace enduring {

/// The solid angle under which a point sees a triangle [sr], positive if the triangle shows the point its
/// back: if its normal (b - a) x (c - a) points away from the point.
double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& point);

/// How often a closed surface winds around a point: 1 inside of a body, 0 outside, 2 inside of two bodies in
/// one mesh. Close to a whole number.
double winding(const SurfaceMesh& mesh, const Vec3& point);

/// The vertices of one surface that are inside another one, ascending.
std::vector<int> vertices_inside(const SurfaceMesh& one, const SurfaceMesh& other);

/// Of each edge of a surface, once, the middle, if it is inside another surface. By faces, then by their
/// corners in order; an edge counts at the face in which it runs from the smaller to the larger vertex.
std::vector<Vec3> middles_inside(const SurfaceMesh& one, const SurfaceMesh& other);

}  // namespace enduring
