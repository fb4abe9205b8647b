#pragma once

#include "common/geometry/surface_topology.hpp"
#include "common/geometry/vector.hpp"

#include <span>

namespace enduring {

/// One length that tells how large a surface is, the same however it lies and is cut into faces [m]: 6 V / A,
/// which is the edge of a cube, the diameter of a ball, three times the thickness of a thin plate. (Grains
/// and drops are measured alike: the Sauter diameter.) What has no volume, since it has a border, is as large
/// as the cube with its area. Points and edges alone are as large as the ball about their mean that holds
/// them: its diameter.
/// @return  0 for a surface without area
double surface_size(const SurfaceTopology& surface, std::span<const Vec3> positions);

}  // namespace enduring
