#include "chapters/12_joints/experiments/machine.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/driven_body.hpp"
#include "common/simulation/energy.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace enduring;
using chapter12::Machine;

namespace {

constexpr double gravity = 9.81;

/// A box that moves as given.
int add_driven(Machine& machine, const Vec3& centre, const Vec3& velocity, const Vec3& spin)
{
    SurfaceMesh mesh = box(Vec3(0.2, 0.2, 0.2));
    for (Vec3& vertex : mesh.vertices)
        vertex += centre;
    machine.scene.world.bodies.push_back(
        std::make_unique<DrivenBody>("drive", mesh, centre, GivenMotion::steady(velocity, spin)));
    return static_cast<int>(machine.scene.world.bodies.size()) - 1;
}

}  // namespace

TEST_CASE("driven joints: what is welded to a turntable goes round with it, and is held by m r omega^2")
{
    const double omega = 2, radius = 0.5, dt = 0.005;
    Machine machine(dt, Vec3::Zero());
    machine.add_box(Vec3(0.1, 0.1, 0.1), 3, Vec3(radius, 0, 0), 0, Vec3(0, 0, -omega * radius),
                    Vec3(0, omega, 0));
    const int table = add_driven(machine, Vec3::Zero(), Vec3::Zero(), Vec3(0, omega, 0));
    machine.add_joint(JointKind::fixed, 0, table, Vec3(radius, 0, 0));
    machine.run(1);
    CHECK(machine.worst_error() <= 1e-9);
    const Vec3 centre = machine.rigid(0).motion().pose().position;
    CHECK((centre - radius * Vec3(std::cos(omega), 0, -std::sin(omega))).norm() <= 1e-9);
    CHECK(machine.scene.world.joints[0].force.norm() ==
          doctest::Approx(3 * radius * omega * omega).epsilon(omega * omega * dt * dt));
    CHECK(machine.scene.world.thrown_away == 0);
}

TEST_CASE(
    "driven joints: a body that rises pulls a box by a rope, when the rope is taut, and does the work of lifting")
{
    Machine machine(0.01);
    machine.add_box(Vec3::Constant(0.1), 2, Vec3(0, -1, 0));
    const int drive = add_driven(machine, Vec3::Zero(), Vec3(0, 0.5, 0), Vec3::Zero());
    Joint rope = make_rod(machine.scene.world, "rope", 0, drive, Vec3(0, -1, 0), Vec3::Zero());
    rope.way.low = -std::numeric_limits<double>::infinity();
    machine.scene.world.joints.push_back(rope);
    machine.run(1);
    const World& world = machine.scene.world;
    CHECK(way_of(world, world.joints[0]) == doctest::Approx(1).epsilon(1e-9));
    CHECK(world.joints[0].force.y() == doctest::Approx(2 * gravity).epsilon(1e-6));
    CHECK(world.bodies[0]->mean_velocity().y() == doctest::Approx(0.5).epsilon(1e-6));
    const double lifted = world.driven, height = world.bodies[0]->centre().y();
    machine.run(1);
    CHECK(world.driven - lifted ==
          doctest::Approx(2 * gravity * (world.bodies[0]->centre().y() - height)).epsilon(1e-6));
    CHECK(world.ended_badly == 0);
}

TEST_CASE("driven joints: a motor on a turntable keeps its speed against the table")
{
    Machine machine(0.01, Vec3::Zero());
    machine.add_box(Vec3(0.4, 0.1, 0.1), 1, Vec3::Zero());
    const int table = add_driven(machine, Vec3::Zero(), Vec3::Zero(), Vec3(0, 0, 3));
    Joint& hinge = machine.add_joint(JointKind::hinge, 0, table, Vec3::Zero());
    hinge.turn.motor_speed = -5;
    hinge.turn.motor_most = 10;
    machine.run(1);
    CHECK(machine.rigid(0).motion().angular_velocity().z() == doctest::Approx(-2).epsilon(1e-5));
    CHECK(machine.scene.world.ended_badly == 0);
}
