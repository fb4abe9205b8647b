#include "common/geometry/box_shapes.hpp"
#include "common/rigid/mass_properties.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/step.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>

using namespace enduring;

namespace {

const Vec3 gravity(0, -9.81, 0);
constexpr double mass = 3, lever = 0.15, about_end = mass * ((0.09 + 0.0016) / 12 + lever * lever);

/// A bar of 0.3 x 0.04 x 0.1 m that lies along x on a hinge along z at its end, the origin.
std::unique_ptr<RigidBody> bar_on_hinge()
{
    SurfaceMesh mesh = box({2 * lever, 0.04, 0.1});
    for (Vec3& vertex : mesh.vertices)
        vertex.x() += lever;
    auto bar = std::make_unique<RigidBody>("bar", mesh, with_mass(mass_properties(mesh, 1), mass));
    bar->pin(Vec3::Zero(), Vec3::UnitZ());
    return bar;
}

}  // namespace

TEST_CASE("hinges: a step of a swing loses (T dt)^2 / 2 I, but for what the turn of gravity's lever gives")
{
    const auto bar = bar_on_hinge();
    constexpr double dt = 0.01;
    double largest = 0;
    for (int step = 0; step < 200; ++step) {
        const double torque = mass * Vec3(bar->motion().centre().cross(gravity)).z(),
                     before = bar->energy(gravity).total();
        bar->predict(gravity, dt);
        const double given = bar->turned_lever_work(gravity, dt);
        bar->commit(dt);
        const double change = bar->energy(gravity).total() - before;
        CHECK(change - given == doctest::Approx(-torque * torque * dt * dt / (2 * about_end)).epsilon(1e-9));
        largest = std::max(largest, given / bar->energy(gravity).kinetic);
    }
    CHECK(largest > 1e-3);  // more than a step may gain
}

TEST_CASE("hinges: no step of a short pendulum is thrown away")
{
    World world;
    world.gravity = gravity;
    world.bodies.push_back(bar_on_hinge());
    Solver solver;
    solver.max_halvings = 5;
    Contacts contacts;
    for (int step = 0; step < 200; ++step)
        advance(world, contacts, solver, 0.01);
    CHECK(world.thrown_away == 0);
    CHECK(world.ended_badly == 0);
}

TEST_CASE(
    "hinges: a force on the centre turns a body about its pin, and gravity accelerates its vertices as it says")
{
    const auto bar = bar_on_hinge();
    bar->add_load({.force = TimedVector(Vec3(0, 7, 0))});
    bar->predict(Vec3::Zero(), 0.02);
    CHECK(bar->motion().angular_velocity().z() == doctest::Approx(0.02 * 7 * lever / about_end));
    bar->commit(0.02);

    const auto falling = bar_on_hinge();
    std::vector<Vec3> expected;
    for (int vertex = 0; vertex < 8; ++vertex)
        expected.push_back(falling->acceleration(vertex, gravity));
    falling->predict(gravity, 0.02);
    for (int vertex = 0; vertex < 8; ++vertex)
        CHECK((falling->velocity(vertex) / 0.02 - expected[static_cast<std::size_t>(vertex)]).norm() < 1e-12);
    CHECK(expected[0].norm() > 0.1);
}
