#include "chapters/12_joints/solver.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/moved_mesh.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/make_joint.hpp"
#include "common/simulation/rigid_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <memory>

using namespace enduring;

namespace {

void add(World& world, const SurfaceMesh& mesh, double density, const Vec3& at,
         const Vec3& velocity = Vec3::Zero())
{
    const SurfaceMesh placed = moved(mesh, at);
    world.bodies.push_back(
        std::make_unique<RigidBody>("body", placed, mass_properties(placed, density), velocity));
}

/// Bricks of this length in a row along x, without gravity; those from `heavy` on have eight times the
/// density.
World row_of_bricks(double length, int heavy = 6)
{
    World world;
    world.gravity.setZero();
    for (int i = 0; i < 6; ++i)
        add(world, box({0.9 * length, 0.2 * length, 0.2 * length}), i < heavy ? 1000 : 8000,
            {i * length, 0, 0});
    return world;
}

Joint joint_of(const World& world, JointKind kind, int first, double length)
{
    const double middle = (first + 0.5) * length, half = 0.05 * length;
    if (kind == JointKind::distance)
        return make_rod(world, "rod", first, first + 1, {middle - half, 0, 0}, {middle + half, 0, 0});
    Joint joint = make_joint(world, "joint", kind, first, first + 1, {middle, 0, 0},
                             axes_about(Vec3::UnitX()));
    joint.way.low = -half;
    joint.way.high = half;
    joint.way.bounce = 0.5;
    joint.bodies_touch = first % 2 == 1;
    return joint;
}

Vec3 momentum_of(const World& world)
{
    Vec3 sum = Vec3::Zero();
    for (const auto& body : world.bodies)
        sum += body->linear_momentum();
    return sum;
}

/// The most energy that is gained in one of twenty steps, over what there is at first.
double most_gained(World& world, double dt)
{
    ContactParameters parameters;
    parameters.friction = MassSplitting{.mu_s = 0.4, .mu_d = 0.4};
    ImplicitSettings settings;
    settings.record = [](const SolveRecord&) {};
    const Solver solver = chapter12_solver(parameters, settings);
    Contacts contacts;
    const double first = total_energy(world).kinetic;
    double before = first, most = 0;
    for (int step = 0; step < 20; ++step) {
        advance(world, contacts, solver, dt);
        const double now = total_energy(world).kinetic;
        most = std::max(most, now - before);
        before = now;
    }
    return most / first;
}

}  // namespace

TEST_CASE(
    "hit machines: a row of joined bricks keeps its momentum and gains no energy, however hard it is hit")
{
    for (const JointKind kind : {JointKind::ball, JointKind::hinge, JointKind::slider, JointKind::universal,
                                 JointKind::fixed, JointKind::distance})
        for (const double speed : {10.0, 30.0, 50.0})
            for (const double dt : {0.005, 0.01, 0.02}) {
                CAPTURE(static_cast<int>(kind));
                CAPTURE(speed);
                CAPTURE(dt);
                World world = row_of_bricks(0.2);
                for (int i = 0; i < 5; ++i)
                    world.joints.push_back(joint_of(world, kind, i, 0.2));
                add(world, sphere(0.05), 8000, {0.36, 0.24, -0.004}, speed * Vec3(-0.13, -1, -0.1));
                const Vec3 momentum = momentum_of(world);
                CHECK(most_gained(world, dt) < 0.005);
                CHECK((momentum_of(world) - momentum).norm() < 1e-9 * momentum.norm());
            }
}

TEST_CASE("hit machines: bricks on ropes whose forces are not found stand still, and gain nothing by it")
{
    for (const double speed : {36.0, 38.0, 40.0, 42.0, 44.0}) {
        CAPTURE(speed);
        const double length = 0.296;
        World world = row_of_bricks(length, 4);
        for (int i = 0; i < 5; ++i) {
            Joint rope = joint_of(world, JointKind::distance, i, length);
            rope.way.low = -std::numeric_limits<double>::infinity();
            rope.bodies_touch = i == 0 || i == 3;
            world.joints.push_back(rope);
        }
        add(world, sphere(0.0994), 8000, {1.21, 0.355, -0.0107}, speed * Vec3(-0.15, -1, 0.09));
        CHECK(most_gained(world, 0.005) < 0.005);
    }
}

TEST_CASE("hit machines: what a limit sends back does not pass the other one, however fast it is")
{
    for (const double speed : {0.5, 2.0, 10.0, 50.0}) {
        CAPTURE(speed);
        World world;
        world.gravity.setZero();
        add(world, box({0.2, 0.1, 0.1}), 1000, Vec3::Zero(), {speed, 0, 0});
        Joint slider = make_joint(world, "slider", JointKind::slider, 0, -1, Vec3::Zero(),
                                  axes_about(Vec3::UnitX()));
        slider.way.low = -0.01;
        slider.way.high = 0.015;
        slider.way.bounce = 0.9;
        world.joints.push_back(slider);
        const Solver solver = chapter12_solver({});
        Contacts contacts;
        double least = 0, most = 0;
        for (int step = 0; step < 40; ++step) {
            advance(world, contacts, solver, 0.01);
            const double way = (world.bodies[0]->positions_t0()[0] + Vec3(0.1, 0.05, 0.05)).x();
            least = std::min(least, way);
            most = std::max(most, way);
        }
        CHECK(least > -0.01 - 1e-9);
        CHECK(most < 0.015 + 1e-9);
        CHECK(most > 0.014);
    }
}
