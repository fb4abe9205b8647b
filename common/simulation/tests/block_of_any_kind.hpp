#pragma once

#include "common/geometry/box_shapes.hpp"
#include "common/geometry/quadratic.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <array>
#include <memory>
#include <string>

namespace enduring::tests {

enum class BodyKind { rigid, linear, quadratic, still };

/// How finely a block is cut along x, y and z: the sides of one that
/// does not deform, the inside of one that does.
struct BlockCells {
    std::array<int, 3> sides{2, 2, 2}, inside{2, 1, 1};
};

/// A tumbling block of side about 1 around a place, of any kind: 10 kg/m^3, soft if it deforms.
inline std::unique_ptr<Body> block(const std::string& name, BodyKind kind, const Vec3& place,
                                   const Vec3& velocity, const BlockCells& cells = {})
{
    const Vec3 size(1, 0.9, 1.1), turning(0.3, 0.2, -0.5);
    if (kind == BodyKind::rigid || kind == BodyKind::still) {
        SurfaceMesh mesh = box(size, cells.sides);
        for (Vec3& x : mesh.vertices)
            x += place;
        if (kind == BodyKind::rigid)
            return std::make_unique<RigidBody>(name, mesh, mass_properties(mesh, 10), velocity, turning);
        return std::make_unique<StaticBody>(
            name, SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces), mesh.vertices);
    }
    DeformableSettings settings;
    settings.material.density = 10;
    settings.material.young = 1e4;
    settings.material.poisson = 0.3;
    settings.position = place;
    settings.velocity = velocity;
    settings.angular_velocity = turning;
    const TetrahedralMesh mesh = bar(size, cells.inside);
    if (kind == BodyKind::quadratic)
        return std::make_unique<DeformableBody>(name, with_edge_midpoints(mesh), settings);
    return std::make_unique<DeformableBody>(name, mesh, settings);
}

}  // namespace enduring::tests
