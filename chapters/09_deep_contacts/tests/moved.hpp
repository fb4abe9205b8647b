#pragma once

#include "common/geometry/meshes.hpp"

namespace enduring {

inline SurfaceMesh moved(SurfaceMesh mesh, const Vec3& by)
{
    for (Vec3& x : mesh.vertices)
        x += by;
    return mesh;
}

}  // namespace enduring
