#include "chapters/12_joints/experiments/machine.hpp"
#include "chapters/12_joints/joint_motion.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace enduring;
using chapter12::Machine;

namespace {

constexpr double gravity = 9.81;

/// About z through its centre [kg m^2].
double inertia(double mass, const Vec3& size)
{
    return mass * (size.x() * size.x() + size.y() * size.y()) / 12;
}

}  // namespace

TEST_CASE("drives: two hinges with a gear turn in its ratio, and a torque on one is that of both inertias")
{
    const Vec3 size(0.4, 0.1, 0.1);
    for (const double ratio : {-2.0, 0.5}) {
        CAPTURE(ratio);
        Machine machine(0.01, Vec3::Zero());
        machine.add_box(size, 1, Vec3::Zero());
        machine.add_box(size, 3, Vec3(2, 0, 0));
        Joint& first = machine.add_joint(JointKind::hinge, 0, -1, Vec3::Zero());
        first.turn.motor_speed = 1e3;
        first.turn.motor_most = 0.2;
        machine.add_joint(JointKind::hinge, 1, -1, Vec3(2, 0, 0));
        machine.scene.world.joints.push_back(make_gear("gear", machine.scene.world, 0, 1, ratio));
        double worst = 0;
        machine.run(1, [&] {
            const World& world = machine.scene.world;
            worst = std::max(worst, std::abs(gear_error(world, world.joints[2])));
        });
        CHECK(worst <= 1e-9);
        const double felt = inertia(1, size) + ratio * ratio * inertia(3, size);
        CHECK(machine.rigid(0).motion().angular_velocity().z() == doctest::Approx(0.2 / felt).epsilon(1e-6));
        CHECK(machine.rigid(1).motion().angular_velocity().z() ==
              doctest::Approx(ratio * 0.2 / felt).epsilon(1e-6));
        const double of_gear = ratio * 0.2 / felt * inertia(3, size);  // what turns the second one
        CHECK(machine.scene.world.joints[2].torque.z() == doctest::Approx(of_gear).epsilon(1e-6));
        CHECK(machine.scene.world.thrown_away == 0);
    }
}

TEST_CASE(
    "drives: a motor goes to its angle, stops there in the time of its largest torque, and holds a load")
{
    const Vec3 size(0.4, 0.1, 0.1);
    const double most = 0.05, target = 1.5, start = most / inertia(1, size), brake = start / 2;
    Machine machine(0.005, Vec3::Zero());
    machine.add_box(size, 1, Vec3::Zero());
    Joint& hinge = machine.add_joint(JointKind::hinge, 0, -1, Vec3::Zero());
    hinge.turn.motor_target = target;
    hinge.turn.motor_speed = std::numeric_limits<double>::infinity();
    hinge.turn.motor_most = most;
    double arrived = 0, farthest = 0;
    machine.run(3, [&] {
        const World& world = machine.scene.world;
        farthest = std::max(farthest, world.joints[0].angle);
        CHECK(std::abs(world.joints[0].turn_torque) <= most * (1 + 1e-9));
        if (arrived == 0 && std::abs(world.joints[0].angle - target) < 1e-3)
            arrived = world.time;
    });
    // v^2 / 2 (1 / start + 1 / brake) = target, and the time is v (1 / start + 1 / brake)
    const double both = 1 / start + 1 / brake;
    CHECK(arrived == doctest::Approx(std::sqrt(2 * target * both)).epsilon(0.05));
    CHECK(farthest <= target + 1e-6);
    CHECK(machine.scene.world.joints[0].angle == doctest::Approx(target).epsilon(1e-6));
}

TEST_CASE("drives: a motor follows its target at one speed, also where its step is taken in parts")
{
    const Vec3 size(0.4, 0.1, 0.1);
    const double rate = 1;  // of the target [rad/s]
    for (const double spin : {0.0, 100.0}) {
        CAPTURE(spin);
        Machine machine(0.01, Vec3::Zero());
        machine.add_box(size, 1, Vec3::Zero());
        Joint& hinge = machine.add_joint(JointKind::hinge, 0, -1, Vec3::Zero());
        hinge.turn.motor_speed = 20;
        hinge.turn.motor_most = 1e7;  // can stop at once, so it does not lag
        // a second body turns so fast that all steps are taken in parts
        machine.add_box(Vec3(0.1, 0.1, 0.1), 1, Vec3(2, 0, 0), 0, Vec3::Zero(), Vec3(0, 0, spin));
        World& world = machine.scene.world;
        for (int step = 1; step <= 20; ++step) {
            world.joints[0].turn.motor_target = rate * machine.scene.dt * step;
            machine.run(machine.scene.dt);
            CHECK((world.work.parts > 1) == (spin > 0));
            CHECK(world.joints[0].angle == doctest::Approx(rate * machine.scene.dt * step).epsilon(1e-6));
            CHECK(machine.rigid(0).motion().angular_velocity().z() == doctest::Approx(rate).epsilon(1e-6));
        }
    }
}

TEST_CASE("drives: a motor with a target carries the load that hangs on it, if its torque is enough")
{
    Machine machine(0.01);
    machine.add_bar(Vec3::Zero(), Vec3(1, 0, 0), 1);
    Joint& hinge = machine.add_joint(JointKind::hinge, 0, -1, Vec3::Zero());
    hinge.turn.motor_target = 0.5;
    hinge.turn.motor_speed = 1;
    hinge.turn.motor_most = 20;
    machine.run(2);
    const Joint& now = machine.scene.world.joints[0];
    CHECK(now.angle == doctest::Approx(0.5).epsilon(1e-6));
    CHECK(now.turn_torque == doctest::Approx(gravity / 2 * std::cos(0.5)).epsilon(1e-5));
}

TEST_CASE("drives: a limit sends back by its coefficient of restitution, and what rests on it stays")
{
    for (const double bounce : {0.0, 0.5, 1.0}) {
        CAPTURE(bounce);
        Machine machine(0.01, Vec3::Zero());
        const Vec3 omega(0, 0, 3), centre(0.5, 0, 0);
        machine.add_box(Vec3(1, 0.1, 0.1), 1, centre, 0, omega.cross(centre), omega);
        Joint& hinge = machine.add_joint(JointKind::hinge, 0, -1, Vec3::Zero());
        hinge.turn.low = -10;
        hinge.turn.high = 0.7;
        hinge.turn.bounce = bounce;
        machine.run(0.5);
        CHECK(machine.rigid(0).motion().angular_velocity().z() == doctest::Approx(-3 * bounce).epsilon(2e-4));
        CHECK(machine.scene.world.ended_badly == 0);
    }
    Machine machine(0.002);
    machine.add_box(Vec3::Constant(0.1), 2, Vec3::Zero());
    Joint& slider = machine.add_joint(JointKind::slider, 0, -1, Vec3::Zero(), Vec3::UnitY());
    slider.way.low = -0.5;
    slider.way.high = 1;
    slider.way.bounce = 0.6;
    double highest = -1;
    machine.run(0.7, [&] {
        if (machine.scene.world.time > 0.33)  // it has struck at 0.319 s
            highest = std::max(highest, machine.scene.world.bodies[0]->centre().y());
    });
    CHECK(highest == doctest::Approx(-0.5 + 0.36 * 0.5).epsilon(0.02));
    machine.run(3);
    CHECK(std::abs(machine.scene.world.bodies[0]->mean_velocity().y()) <= 1e-6);
    CHECK(machine.scene.world.bodies[0]->centre().y() == doctest::Approx(-0.5).epsilon(1e-9));
}
