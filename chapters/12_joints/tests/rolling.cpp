#include "chapters/12_joints/solver.hpp"
#include "common/experiments/run/run.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/rigid_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace enduring;

namespace {

constexpr double radius = 0.1, dt = 1.0 / 60;

/// A prism of so many sides that stands on a vertex and rolls over so many of its facets in a step.
Scene rolling_prism(int sides, double facets)
{
    const double facet = 2 * std::numbers::pi / sides, spin = facets * facet / dt;
    SurfaceMesh mesh;
    for (const double z : {-0.15, 0.15})
        for (int i = 0; i < sides; ++i)
            mesh.vertices.emplace_back(radius * std::cos(i * facet), radius * (1 + std::sin(i * facet)), z);
    for (int i = 0; i < sides; ++i) {
        const int next = (i + 1) % sides;
        mesh.faces.push_back({i, next, next + sides});
        mesh.faces.push_back({i, next + sides, i + sides});
    }
    for (int i = 1; i + 1 < sides; ++i) {
        mesh.faces.push_back({0, i + 1, i});
        mesh.faces.push_back({sides, sides + i, sides + i + 1});
    }
    Scene scene;
    scene.dt = dt;
    scene.contact.friction = MassSplitting{.mu_s = 0.5, .mu_d = 0.5};
    scene.world.planes.push_back({"ground"});
    scene.world.bodies.push_back(std::make_unique<RigidBody>("prism", mesh, mass_properties(mesh, 1000),
                                                             Vec3(spin * radius, 0, 0), Vec3(0, 0, -spin)));
    return scene;
}

/// The most that it moves with at any time, over what it moves with at first.
double most_kinetic(Scene scene, double seconds)
{
    ImplicitSettings settings;
    settings.record = [](const SolveRecord&) {};
    const Solver solver = chapter12_solver(scene.contact, settings);
    Contacts contacts;
    const double first = total_energy(scene.world).kinetic;
    double most = first;
    for (int step = 0; step < std::lround(seconds / dt); ++step) {
        advance(scene.world, contacts, solver, dt);
        most = std::max(most, total_energy(scene.world).kinetic);
    }
    return most / first;
}

}  // namespace

TEST_CASE("energy: prisms that roll, with half a facet to two in a step, gain nothing")
{
    for (const int sides : {12, 24, 48})
        for (const double facets : {0.6, 0.75, 0.9, 1.75}) {
            CAPTURE(sides);
            CAPTURE(facets);
            // it stands on a vertex at first, and comes down by R (1 - cos(pi / sides)) at most
            const double spin = facets * 2 * std::numbers::pi / sides / dt,
                         fall = 9.81 * radius * (1 - std::cos(std::numbers::pi / sides)),
                         moving = 0.75 * std::pow(spin * radius, 2);
            CHECK(most_kinetic(rolling_prism(sides, facets), 2) <= 1 + fall / moving + 0.01);
        }
}

TEST_CASE("energy: a body without gravity that drifts takes whole steps")
{
    Scene scene = rolling_prism(12, 0);
    scene.world.planes.clear();
    scene.world.bodies[0]->switch_gravity_off();
    dynamic_cast<RigidBody&>(*scene.world.bodies[0]).apply_impulse(0, Vec3(0.1, 0, 0));
    const Solver solver = chapter12_solver(scene.contact);
    Contacts contacts;
    for (int step = 0; step < 10; ++step) {
        advance(scene.world, contacts, solver, dt);
        CHECK(scene.world.work.attempts == 1);
    }
}
