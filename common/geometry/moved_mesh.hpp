#pragma once

#include "common/geometry/meshes.hpp"

namespace enduring {

/// Surfaces at another place. A turn is about the origin, by a Quaternion, an Eigen::AngleAxisd or a rotation
/// matrix: each has its own rounding, so that what one yields is not to the last bit what another does.

/// @param by  added to all vertices [m]
inline SurfaceMesh moved(SurfaceMesh mesh, const Vec3& by)
{
    for (Vec3& vertex : mesh.vertices)
        vertex += by;
    return mesh;
}

template <class Rotation>
SurfaceMesh turned(SurfaceMesh mesh, const Rotation& turn)
{
    for (Vec3& vertex : mesh.vertices)
        vertex = turn * vertex;
    return mesh;
}

/// Turned, then moved.
/// @param at  where the turn's centre comes to lie [m]
template <class Rotation>
SurfaceMesh placed(SurfaceMesh mesh, const Rotation& turn, const Vec3& at)
{
    for (Vec3& vertex : mesh.vertices)
        vertex = turn * vertex + at;
    return mesh;
}

}  // namespace enduring
