#include "chapters/08_contact_by_distance/tests/small_world.hpp"
#include "chapters/09_deep_contacts/inside_pairs.hpp"
#include "chapters/09_deep_contacts/solver.hpp"
#include "common/geometry/moved_mesh.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace enduring;
using distance_tests::add_static;

namespace {

void add_with_mass(World& world, const SurfaceMesh& mesh, double mass)
{
    world.bodies.push_back(std::make_unique<RigidBody>("body " + std::to_string(world.bodies.size()), mesh,
                                                       with_mass(mass_properties(mesh, 1000), mass)));
}

/// A ring about the y axis, 0.1 m to the middle of its tube of 0.025 m.
SurfaceMesh ring()
{
    constexpr int around = 16, across = 8;
    constexpr double full = 2 * std::numbers::pi;
    SurfaceMesh mesh;
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            const double a = full * i / around, b = full * j / across, radius = 0.1 + 0.025 * std::cos(b);
            mesh.vertices.emplace_back(radius * std::cos(a), 0.025 * std::sin(b), radius * std::sin(a));
        }
    const auto at = [](int i, int j) { return (i % around) * across + j % across; };
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            mesh.faces.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
            mesh.faces.push_back({at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
        }
    return mesh;
}

Solver solver_with(double friction)
{
    ContactParameters parameters;
    parameters.friction = MassSplitting{friction, friction};
    return chapter09_solver(parameters);
}

/// Steps that begin with two bodies in each other; edges that pass through faces count, too.
int overlapping_steps(World& world, const Solver& solver, int steps, double dt)
{
    InsidePairs inside;
    Contacts contacts;
    int overlapping = 0;
    for (int i = 0; i < steps; ++i) {
        advance(world, contacts, solver, dt);
        inside.trace(world);
        const LeftOut found = inside.left_out([](int, int) { return 0.0; });
        overlapping += !found.vertices.empty() || !found.edges.empty();
    }
    return overlapping;
}

}  // namespace

TEST_CASE(
    "deep contacts: the rings of a chain that falls taut never come into each other, in long steps, too")
{
    for (const double dt : {0.01, 0.02}) {
        World world;
        const Quaternion upright(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitX()));
        add_static(world, moved(ring(), {0, 2, 0}));
        for (int i = 1; i < 6; ++i)
            add_with_mass(
                world, placed(ring(), i % 2 > 0 ? upright : Quaternion::Identity(), {0.144 * i, 2, 0}), 0.3);
        CAPTURE(dt);
        CHECK(overlapping_steps(world, solver_with(0.3), static_cast<int>(1 / dt), dt) == 0);
    }
}

TEST_CASE(
    "deep contacts: a column whose cubes begin in each other comes out, stands, and nothing comes in again")
{
    for (const double dt : {0.005, 0.01})
        for (const double overlap : {0.02, 0.1}) {
            constexpr int count = 8;
            World world;
            world.planes.push_back({"ground"});
            for (int i = 0; i < count; ++i)
                add_with_mass(world, moved(box(Vec3::Constant(0.2)), {0, 0.1 + 0.2 * (1 - overlap) * i, 0}),
                              1.0 + i);
            const Solver solver = solver_with(0.5);
            overlapping_steps(world, solver, static_cast<int>(1 / dt), dt);
            CAPTURE(dt);
            CAPTURE(overlap);
            CHECK(overlapping_steps(world, solver, static_cast<int>(0.5 / dt), dt) == 0);
            for (int i = 0; i < count; ++i) {
                const Body& cube = *world.bodies[static_cast<std::size_t>(i)];
                CHECK(cube.mean_velocity().norm() < 1e-5);
                CHECK(cube.centre().y() == doctest::Approx(0.1 + 0.2 * i).epsilon(1e-3));
            }
        }
}

TEST_CASE(
    "deep contacts: where two bodies are apart they stay so, though they are in each other at another place")
{
    // a plank that leans with one end in the ground, and falls onto it with the other one
    World world;
    add_static(world, moved(box({4, 1, 4}), {0, -0.5, 0}));
    add_with_mass(
        world, placed(box({2, 0.1, 0.4}), Quaternion(Eigen::AngleAxisd(0.2, Vec3::UnitZ())), {0, 0.238, 0}),
        20);
    InsidePairs inside;
    inside.trace(world);
    const LeftOut left_out = inside.left_out([](int, int) { return 1e-4; });
    CHECK(left_out.vertices.size() == 2);
    Contacts contacts;
    const Solver solver = solver_with(0.5);
    double deepest = 0;
    for (int i = 0; i < 100; ++i) {
        advance(world, contacts, solver, 0.02);
        for (const Vec3& x : world.bodies[1]->positions_t0())
            if (x.x() > 0)
                deepest = std::min(deepest, x.y());
    }
    CHECK(deepest > -1e-4);
    CHECK(world.bodies[1]->centre().y() == doctest::Approx(0.05).epsilon(0.01));
}
