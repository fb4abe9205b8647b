#pragma once

#include "common/geometry/surface_topology.hpp"
#include "common/geometry/vector.hpp"

#include <span>

namespace enduring {

/// How often a surface winds around a point: for a closed one that faces outwards 1
/// inside and 0 outside; over an open one it passes smoothly from one to the other. It
/// looks at every face, so it serves checks, not solvers.
///
/// The sum of the faces' solid angles over 4 pi.
/// @param faces      of the surface, counter-clockwise seen from outside
/// @param positions  of its vertices [m]
/// @param point      not on the surface [m]
/// @see van Oosterom and Strackee 1983, "The solid angle of a plane triangle"
double winding_number(std::span<const Face> faces, std::span<const Vec3> positions, const Vec3& point);

}  // namespace enduring
