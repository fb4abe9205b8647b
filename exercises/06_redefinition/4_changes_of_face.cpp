#include "exercises/06_redefinition/4_changes_of_face.hpp"

#include "chapters/06_redefinition/solver.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/point_masses.hpp"
#include "common/simulation/static_body.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <cmath>

namespace enduring {

double predicted_changes()
{
    not_implemented_yet("6.4");
}

World sliding_tip(double velocity_x, double velocity_z)
{
    World world;
    world.gravity.setZero();
    SurfaceMesh floor = plane_grid(24, 24, {24, 24});
    SurfaceTopology topology(static_cast<int>(floor.vertices.size()), floor.faces);
    world.bodies.push_back(
        std::make_unique<StaticBody>("floor", std::move(topology), std::move(floor.vertices)));
    const Vec3 place(-6.7 * (velocity_x < 0 ? -1 : 1), 1e-9, -4.9 * (velocity_z < 0 ? -1 : 1));
    const std::vector<Vec3> points{place, place + Vec3(4, 1, 0), place + Vec3(-2, 1, 3.5),
                                   place + Vec3(-2, 1, -3.5)};
    world.bodies.push_back(std::make_unique<PointMasses>("tip", points,
                                                         std::vector<Face>{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}},
                                                         1, Vec3(velocity_x, -1e-4, velocity_z)));
    return world;
}

int measured_changes(World& world, int steps, double dt)
{
    not_implemented_yet("6.4");
}

double law_of_changes(double cells_x, double cells_z)
{
    not_implemented_yet("6.4");
}

}  // namespace enduring
