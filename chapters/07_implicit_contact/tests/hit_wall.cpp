#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/rigid_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace enduring;
using namespace enduring::chapter07;

namespace {

/// Rows of bricks, and a cube of 100 kg and 15 m/s that is just about to hit their middle.
Scene hit_wall(int columns, int rows)
{
    std::vector<Box> bricks;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            Box brick;
            brick.mass = 15;
            brick.size = Vec3(0.4, 0.2, 0.2);
            brick.centre = Vec3(0.402 * (column + 0.5 * (row % 2)), 0.1 + 0.2005 * row, 0);
            bricks.push_back(brick);
        }
    Scene scene = scene_of(bricks, 0.01, 0, 0.5, 0.5);
    SurfaceMesh shot = box(Vec3(0.3, 0.3, 0.3));
    const Eigen::AngleAxisd turn(0.4, Vec3(1, 2, 3).normalized());
    for (Vec3& vertex : shot.vertices)
        vertex = Vec3(0.201 * columns + 0.03, 0.1 * rows, -0.4) + turn * vertex;
    scene.world.bodies.push_back(std::make_unique<RigidBody>(
        "shot", shot, with_mass(mass_properties(shot, 1000), 100), Vec3(0, 0, 15), Vec3::Zero()));
    return scene;
}

double momentum_along_shot(const World& world)
{
    double sum = 0;
    for (const auto& body : world.bodies)
        sum += body->linear_momentum().z();
    return sum;
}

}  // namespace

TEST_CASE("hit wall: a step keeps to its budget, its parts lose no momentum, and none gains energy")
{
    Scene scene = hit_wall(5, 4);
    ImplicitSettings settings;
    long unsolved = 0;
    settings.record = [&](const SolveRecord& record) { unsolved += record.unsolved_islands; };
    const Solver solver = chapter07_solver(scene.contact, settings);
    Contacts contacts;
    long most = 0;
    double energy = total_energy(scene.world).total(), gained = 0;
    const double first = momentum_along_shot(scene.world);
    for (int i = 0; i < 15; ++i) {
        advance(scene.world, contacts, solver, scene.dt);
        most = std::max(most, scene.world.work.newton_steps);
        const double next = total_energy(scene.world).total();
        gained = std::max(gained, next - energy);
        energy = next;
    }
    CAPTURE(most);
    CAPTURE(scene.world.ended_badly);
    CAPTURE(unsolved);
    CAPTURE(gained);
    CAPTURE(momentum_along_shot(scene.world) / first);
    CHECK(most < 1500);
    CHECK(unsolved > 0);
    CHECK(scene.world.ended_badly == 0);
    CHECK(gained < 1e-3 * energy);
    CHECK(momentum_along_shot(scene.world) > 0.9 * first);
}
