#pragma once

#include "common/geometry/box_shapes.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/step.hpp"

#include <memory>
#include <vector>

namespace enduring::chapter07 {

/// A corner of a cube of 10 kg with the plane below it; it feels a quarter of the cube's mass.
inline Contact corner_on_plane(int vertex = 0)
{
    return {ContactKind::vertex_plane, 0, 0, vertex, -1, {vertex, -1, -1, -1}, {1, 0, 0, 0}};
}
inline constexpr double corner_mass = 2.5;

/// A cube whose lower side is at this height, as it will move in a step.
inline World cube_above_plane(double height, double dt, double size = 1, const Vec3& velocity = Vec3::Zero())
{
    World world;
    world.gravity.setZero();
    world.planes.push_back({"ground"});
    SurfaceMesh mesh = box(Vec3::Constant(size));
    for (Vec3& x : mesh.vertices)
        x.y() += 0.5 * size + height;
    world.bodies.push_back(
        std::make_unique<RigidBody>("cube", mesh, with_mass(mass_properties(mesh, 1000), 10), velocity));
    for (const auto& body : world.bodies)
        body->predict(world.gravity, dt);
    return world;
}

/// The corners of its lower side.
inline std::vector<int> lower_corners(const Body& cube)
{
    std::vector<int> lower;
    for (int v = 0; v < 8; ++v)
        if (cube.positions_t0()[static_cast<std::size_t>(v)].y() < cube.centre().y())
            lower.push_back(v);
    return lower;
}

}  // namespace enduring::chapter07
