#include "chapters/05_categorisation/experiments/cube_in_floor.hpp"

#include "common/geometry/box_shapes.hpp"

namespace enduring::chapter05 {

std::unique_ptr<StaticBody> still(SurfaceMesh mesh, const Vec3& at)
{
    for (Vec3& x : mesh.vertices)
        x += at;
    SurfaceTopology topology(static_cast<int>(mesh.vertices.size()), std::move(mesh.faces));
    return std::make_unique<StaticBody>("still", std::move(topology), std::move(mesh.vertices));
}

World cube_in_floor()
{
    World world;
    world.bodies.push_back(still(plane_grid(4, 4, {4, 4}), Vec3::Zero()));
    world.bodies.push_back(still(box({1, 1, 1}), {0.2, 0.49, 0.3}));
    return world;
}

int lowest_edge_along(const Body& body, const Vec3& direction)
{
    int found = -1;
    double lowest = 1e9;
    for (int edge = 0; edge < static_cast<int>(body.surface().edges().size()); ++edge) {
        const auto [a, b] = body.surface().edges()[edge];
        const Vec3 &start = body.positions_t0()[a], &end = body.positions_t0()[b];
        if ((end - start).normalized().cross(direction).norm() < 1e-12 && start.y() + end.y() < lowest) {
            lowest = start.y() + end.y();
            found = edge;
        }
    }
    return found;
}

Contact edge_pair(const World& world, const Vec3& cube_edge, const Vec3& floor_edge, const Vec3& out)
{
    const Body &cube = *world.bodies[cube_body], &floor = *world.bodies[floor_body];
    Contact contact{ContactKind::edge_edge, cube_body, floor_body, lowest_edge_along(cube, cube_edge),
                    lowest_edge_along(floor, floor_edge)};
    const auto along = [](const Body& body, int edge) {
        const auto [a, b] = body.surface().edges()[edge];
        return Vec3(body.positions_t0()[b] - body.positions_t0()[a]);
    };
    contact.orientation = along(cube, contact.feature_a).cross(along(floor, contact.feature_b)).dot(out) > 0
                              ? 1
                              : -1;
    return contact;
}

}  // namespace enduring::chapter05
