#pragma once

#include "common/geometry/meshes.hpp"

namespace enduring {

inline SurfaceMesh moved(SurfaceMesh mesh, const Vec3& by, const Quaternion& turn = Quaternion::Identity())
{
    for (Vec3& x : mesh.vertices)
        x = turn * x + by;
    return mesh;
}

}  // namespace enduring
