#include "exercises/06_redefinition/4_changes_of_face.hpp"

#include "chapters/06_redefinition/solver.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/point_masses.hpp"
#include "common/simulation/static_body.hpp"

#include <cmath>

namespace enduring {

double predicted_changes() { return 20; }

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
    ContactParameters parameters;
    parameters.stiffness = 1e-9;  // it should be found, not pushed
    const Solver solver = chapter06_solver(parameters);
    Contacts contacts;
    int face = -1, changes = 0;
    for (int step = 0; step < steps; ++step) {
        advance(world, contacts, solver, dt);
        for (const Contact& contact : contacts) {
            if (contact.kind != ContactKind::vertex_face || contact.body_a != 1 || contact.feature_a != 0)
                continue;
            if (face >= 0 && contact.feature_b != face)
                ++changes;
            face = contact.feature_b;
        }
    }
    return changes;
}

double law_of_changes(double cells_x, double cells_z)
{
    // Lines x = i, lines z = j, and the diagonals on which x + z (or x - z) is a whole number.
    const double borders = std::abs(cells_x) + std::abs(cells_z);
    const double diagonals = std::abs(cells_x - cells_z);
    return borders + diagonals;
}

}  // namespace enduring
