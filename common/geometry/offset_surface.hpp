#pragma once

#include "common/geometry/surface_topology.hpp"
#include "common/geometry/vector.hpp"

#include <span>
#include <vector>

namespace enduring {

/// A surface's vertices, each moved along the mean of its faces' normals, weighted by area.
///
/// @param faces      of the surface, counter-clockwise seen from outside
/// @param positions  of its vertices [m]
/// @param distance   outwards [m]; negative ones shrink a body
/// @return  a position for each vertex [m]; a vertex without a face, or whose faces cancel, stays
std::vector<Vec3> offset_surface(std::span<const Face> faces, std::span<const Vec3> positions,
                                 double distance);

}  // namespace enduring
