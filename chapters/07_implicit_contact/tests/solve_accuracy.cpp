#include "chapters/07_implicit_contact/implicit_contact.hpp"

#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "chapters/07_implicit_contact/tests/only_island.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/rigid_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace enduring;
using namespace enduring::chapter07;

namespace {

/// A cube of 1 m and 10 kg on a ground at this height, which it presses by a micrometre.
World cube_on_ground_at(double height, const Vec3& velocity = Vec3::Zero())
{
    World world;
    world.planes.push_back({"ground", height * Vec3::UnitY(), Vec3::UnitY()});
    SurfaceMesh mesh = box(Vec3::Ones());
    for (Vec3& x : mesh.vertices)
        x.y() += 0.5 + height - 1e-6;
    world.bodies.push_back(
        std::make_unique<RigidBody>("cube", mesh, with_mass(mass_properties(mesh, 1000), 10), velocity));
    return world;
}

}  // namespace

TEST_CASE("solve accuracy: rounding leaves what a spring makes of the last digit of its coordinates")
{
    constexpr double dt = 1e-3, height = 700, least = 0.1;
    World world = cube_on_ground_at(height);
    for (const auto& body : world.bodies)
        body->predict(world.gravity, dt);
    Contacts contacts{{ContactKind::vertex_plane, 0, 0, 0, -1, {0, -1, -1, -1}, {1, 0, 0, 0}}};
    contacts[0].spring.stiffness = 3e5;
    StepProblem step = set_up_only_island(world, contacts, {}, {}, {1, dt}, true);
    REQUIRE(step.problem.rows.size() == 1);
    CHECK(rounding_residual(world, step, least) == 0);  // nothing pushes

    const double mass = mass_along(step.problem.rows[0].law.normal, step.responses[0]),
                 digit = contacts[0].spring.stiffness * dt * std::numeric_limits<double>::epsilon();
    for (const double acting : {1e-3, 20.0}) {
        contacts[0].impulse = acting * Vec3::UnitY();
        update_kinematics(world, step);
        const double impulse = 4 * digit * (height - 1e-6 + dt * acting / mass),
                     expected = impulse / std::sqrt(mass) / std::max(least, acting / std::sqrt(mass));
        CHECK(rounding_residual(world, step, least) / expected == doctest::Approx(1));
    }
}

TEST_CASE(
    "implicit contact: what slides far from the origin, in short steps, is solved as well as its coordinates tell")
{
    constexpr double dt = 1e-4;
    int unsolved = 0, newton_steps = 0;
    ContactParameters parameters;
    parameters.friction = MassSplitting{.mu_s = 0.5, .mu_d = 0.5};
    ImplicitSettings settings;
    settings.record = [&](const SolveRecord& record) {
        unsolved += !record.converged;
        newton_steps += record.newton_steps;
    };
    const Solver solver = chapter07_solver(parameters, settings);
    World world = cube_on_ground_at(1000, Vec3(1, -1e-2, 0.3));
    Contacts contacts;
    for (int i = 0; i < 100; ++i)
        advance(world, contacts, solver, dt);
    CHECK(newton_steps > 20);
    CHECK(newton_steps < 1000);
    CHECK(unsolved == 0);
}

TEST_CASE("solve accuracy: least of an island is what gravity does, or the rounding of its largest body")
{
    constexpr double dt = 0.01;
    World world = cube_on_ground_at(0);
    SurfaceMesh small = box(Vec3::Constant(0.1));
    world.bodies.push_back(
        std::make_unique<RigidBody>("small", small, with_mass(mass_properties(small, 1000), 6)));
    Island island;
    island.bodies = {0, 1};
    CHECK(least_speed(world, island, dt) ==
          doctest::Approx(std::sqrt(16.0) * world.gravity.norm() * dt).epsilon(1e-12));
    world.gravity.setZero();
    CHECK(least_speed(world, island, dt) ==
          doctest::Approx(std::sqrt(16.0) * scale_parts.least_answer * world.bodies[0]->size() / dt)
              .epsilon(1e-12));
}
