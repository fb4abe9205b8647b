#include "chapters/engines/engine.hpp"
#include "chapters/engines/judge.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace enduring;
using namespace enduring::engines;

namespace {

void add_box(Scene& scene, const std::string& name, const Vec3& size, const Vec3& centre, double mass,
             const Vec3& velocity = Vec3::Zero(), const Vec3& spin = Vec3::Zero())
{
    SurfaceMesh mesh = box(size);
    const Eigen::AngleAxisd turn(0.3, Vec3::UnitY());
    for (Vec3& x : mesh.vertices)
        x = centre + turn * x;
    scene.world.bodies.push_back(
        std::make_unique<RigidBody>(name, mesh, with_mass(mass_properties(mesh, 1), mass), velocity, spin));
}

/// How far an engine lets a body rest from where it should: its default slop, round corners and soft contacts
/// [m].
double slop_of(const Engine& engine)
{
    return engine.name == "Jolt" || engine.name == "MuJoCo of Debian" ? 0.021 : 0.01;
}

/// Runs a check on every engine that is here; a word about the others.
template <class Check>
void with_all(const Check& check)
{
    for (const Engine& engine : all_engines()) {
        CAPTURE(engine.name);
        if (engine.is_here())
            check(engine);
        else
            MESSAGE("skipped: " << engine.missing);
    }
}

}  // namespace

TEST_CASE("engines: a box that falls on a floor comes to rest on it, to the slop of its engine")
{
    with_all([](const Engine& engine) {
        Scene scene;
        scene.world.planes.push_back({"ground"});
        add_box(scene, "box", {0.6, 0.4, 0.8}, {0.1, 0.25, 0.2}, 3);
        const Trajectory run = engine.run(std::move(scene), engine.plain, 200);
        CHECK(std::abs(run.back().poses[0].position.y() - 0.2) < slop_of(engine));
        CHECK((run.back().poses[0].position - run[150].poses[0].position).norm() < 1e-3);
    });
}

TEST_CASE(
    "engines: metres, kilograms and seconds: bodies fall and turn as they should, and come back in our order")
{
    with_all([](const Engine& engine) {
        Scene scene;
        add_box(scene, "first", {0.3, 0.2, 0.4}, {0, 10, 0}, 2, {1, 0, 0}, {0, 2, 0});
        const SurfaceMesh floor = plane_grid(4, 4, {2, 2});
        scene.world.bodies.push_back(std::make_unique<StaticBody>(
            "floor", SurfaceTopology(static_cast<int>(floor.vertices.size()), floor.faces), floor.vertices));
        add_box(scene, "third", {0.2, 0.5, 0.3}, {3, 20, 0}, 7, {0, 4, -1});
        const Trajectory run = engine.run(std::move(scene), engine.best, 50);
        REQUIRE(run.size() == 51);
        REQUIRE(run.back().poses.size() == 3);
        const double t = 0.5, fall = 0.5 * 9.81 * t * t, rounding = 0.03;  // of symplectic Euler: g t dt / 2
        const auto at = [&](std::size_t body) { return run.back().poses[body].position; };
        CHECK((at(0) - Vec3(0.5, 10 - fall, 0)).norm() < rounding);
        CHECK(at(1).norm() < 1e-12);
        CHECK((at(2) - Vec3(3, 20 + 2 - fall, -0.5)).norm() < rounding);
        const Quaternion turned = run.back().poses[0].orientation *
                                  run.front().poses[0].orientation.conjugate();
        CHECK(turned.angularDistance(Quaternion(Eigen::AngleAxisd(2 * t, Vec3::UnitY()))) < 0.01);
    });
}

TEST_CASE("engines: mass counts: a heavy box pushes a light one away, and keeps most of its speed")
{
    with_all([](const Engine& engine) {
        Scene scene;
        scene.world.gravity = Vec3::Zero();
        scene.contact.friction = MassSplitting{.mu_s = 0, .mu_d = 0};
        add_box(scene, "heavy", {0.5, 0.5, 0.5}, {-0.5, 0, 0}, 30, {1, 0, 0});
        add_box(scene, "light", {0.5, 0.5, 0.5}, {0.3, 0, 0}, 10);
        const Trajectory run = engine.run(std::move(scene), engine.plain, 200);
        const auto speed = [&](std::size_t body) {
            return (run[200].poses[body].position - run[150].poses[body].position).x() / 0.5;
        };
        CHECK(30 * speed(0) + 10 * speed(1) == doctest::Approx(30).epsilon(0.02));
        CHECK(speed(1) > 0.7);
        CHECK(speed(0) < 0.8);
    });
}

TEST_CASE("engines: a cuboid is known by its size and inertia, another body by its hull")
{
    Scene scene;
    add_box(scene, "box", {0.6, 0.4, 0.8}, {1, 2, 3}, 12);
    const EngineScene taken = describe(scene);
    REQUIRE(taken.bodies[0].half_size);
    Vec3 half = *taken.bodies[0].half_size, inertia = taken.bodies[0].inertia;
    for (int i = 0; i < 3; ++i) {  // m (b^2 + c^2) / 12, of whole edges
        const double squares = 4 * (half.squaredNorm() - half[i] * half[i]);
        CHECK(inertia[i] == doctest::Approx(squares));
    }
    std::sort(half.begin(), half.end());
    CHECK((half - Vec3(0.2, 0.3, 0.4)).norm() < 1e-12);
}

TEST_CASE("engines: depth, drift and amplitude are found in poses alone")
{
    Scene scene;
    scene.world.planes.push_back({"ground"});
    add_box(scene, "box", {1, 1, 1}, {0, 0.5, 0}, 1);
    const EngineScene taken = describe(scene);
    Frame start{{taken.bodies[0].frame}}, end = start;
    end.poses[0].position += Vec3(0, -3e-6, 4e-6);
    CHECK(depth_um(taken, end) == doctest::Approx(3).epsilon(1e-6));
    Trajectory run(101, start);
    run.back() = end;
    CHECK(drift_um_per_s(taken, run) == doctest::Approx(5 / 0.5).epsilon(1e-6));
    CHECK(moved_mm(run) == doctest::Approx(5e-3));
    for (std::size_t i = 0; i < run.size(); ++i) {  // comes back to 0.9 of its first angle
        const double time = static_cast<double>(i) / 100,
                     angle = 0.5 * std::cos(2 * std::numbers::pi * time) * (1 - 0.1 * time);
        run[i].poses[0].position = Vec3(std::sin(angle), -std::cos(angle), 0);
    }
    CHECK(amplitude_kept(run, 0) == doctest::Approx(0.9).epsilon(0.01));
    CHECK(amplitude_kept(Trajectory(50, run[0]), 0) == 0);  // stuck
}
