#include "chapters/12_joints/experiments/machine.hpp"
#include "chapters/12_joints/joint_rows.hpp"
#include "chapters/12_joints/solver.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/step_attempt.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace enduring;
using chapter12::Machine;

namespace {

constexpr double gravity = 9.81;

Machine pendulum(double dt = 0.01)
{
    Machine machine(dt);
    machine.add_bar(Vec3::Zero(), Vec3(1, 0, 0), 1);
    machine.add_joint(JointKind::hinge, 0, -1, Vec3::Zero());
    return machine;
}

double energy_of(const Machine& machine)
{
    const World& world = machine.scene.world;
    double sum = total_energy(world).total();
    for (const auto& body : world.bodies)
        sum += machine.scene.dt / 2 * world.gravity.dot(body->linear_momentum());
    return sum;
}

}  // namespace

TEST_CASE("joints: a hinge holds a falling bar to a billionth of its length, and takes none of its energy")
{
    Machine machine = pendulum();
    const double start = energy_of(machine);
    double worst = 0;
    machine.run(5, [&] { worst = std::max(worst, std::abs(energy_of(machine) - start)); });
    CHECK(machine.worst_error() <= 1e-9);
    CHECK(worst <= 0.002 * gravity);
    CHECK(machine.scene.world.thrown_away == 0);
}

TEST_CASE("joints: each kind holds what it locks while its bodies are thrown about")
{
    for (const JointKind kind : {JointKind::ball, JointKind::hinge, JointKind::slider, JointKind::cylinder,
                                 JointKind::universal, JointKind::fixed}) {
        CAPTURE(static_cast<int>(kind));
        Machine machine(0.01);
        const int one = machine.add_box(Vec3(1, 0.3, 0.2), 2, Vec3::Zero(), 0, Vec3(1, 2, 0), Vec3(1, 0, 2)),
                  other = machine.add_box(Vec3(0.8, 0.2, 0.3), 1, Vec3(0.9, 0, 0), 0, Vec3(1, 0, 1),
                                          Vec3(0, -2, 1));
        machine.add_joint(kind, other, one, Vec3(0.5, 0, 0), Vec3(1, 2, 2).normalized());
        machine.run(1);
        CHECK(machine.worst_error() <= 1e-9);
    }
}

TEST_CASE("joints: forces between two bodies change neither momentum nor angular momentum")
{
    Machine machine(0.01, Vec3::Zero());
    machine.add_box(Vec3(1, 0.3, 0.2), 2, Vec3::Zero(), 0, Vec3(1, 2, 0), Vec3(1, 0, 2));
    machine.add_box(Vec3(0.8, 0.2, 0.3), 1, Vec3(0.9, 0, 0), 0, Vec3(1, 0, 1), Vec3(0, -2, 1));
    machine.add_joint(JointKind::ball, 1, 0, Vec3(0.5, 0, 0));
    const auto momenta = [&] {
        Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
        for (const auto& body : machine.scene.world.bodies) {
            sum.head<3>() += body->linear_momentum();
            sum.tail<3>() += body->angular_momentum(Vec3::Zero());
        }
        return sum;
    };
    const Eigen::Matrix<double, 6, 1> start = momenta();
    machine.run(2);
    CHECK((momenta() - start).norm() <= 1e-9);
}

TEST_CASE("joints: what hangs still pulls with its weight, and a beam on a weld with its moment")
{
    Machine machine(0.01);
    const int beam = machine.add_bar(Vec3::Zero(), Vec3(1, 0, 0), 3);
    machine.add_joint(JointKind::fixed, beam, -1, Vec3::Zero());
    machine.run(1);
    const Joint& weld = machine.scene.world.joints[0];
    CHECK((weld.force - Vec3(0, 3 * gravity, 0)).norm() <= 1e-6);
    CHECK((weld.torque - Vec3(0, 0, 3 * gravity / 2)).norm() <= 1e-6);
    CHECK((machine.scene.world.bodies[0]->centre() - Vec3(0.5, 0, 0)).norm() <= 1e-12);
}

TEST_CASE("joints: a heavy body hangs on light links, and they hold to a billionth")
{
    Machine machine(0.01);
    int before = -1;
    for (int i = 0; i < 5; ++i) {
        const int link = machine.add_bar(Vec3(0.2 * i, 0, 0), Vec3(0.2 * (i + 1), 0, 0), 0.1);
        machine.add_joint(JointKind::ball, link, before, Vec3(0.2 * i, 0, 0));
        before = link;
    }
    const int load = machine.add_box(Vec3::Constant(0.2), 100, Vec3(1.1, 0, 0));
    machine.add_joint(JointKind::ball, load, before, Vec3(1, 0, 0));
    machine.run(2);
    CHECK(machine.worst_error() <= 1e-9);
    CHECK(machine.scene.world.ended_badly == 0);
}

TEST_CASE("joints: a rope pulls at its length and is slack below it")
{
    Machine machine(0.01);
    const int bob = machine.add_box(Vec3::Constant(0.1), 2, Vec3(0, -0.5, 0));
    Joint rope = make_rod(machine.scene.world, "rope", bob, -1, Vec3(0, -0.5, 0), Vec3::Zero());
    rope.way.low = -std::numeric_limits<double>::infinity();
    rope.way.high = 1;
    machine.scene.world.joints.push_back(rope);
    double longest = 0;
    bool pulled = false;
    machine.run(1, [&] {
        const Joint& now = machine.scene.world.joints[0];
        longest = std::max(longest, way_of(machine.scene.world, now));
        pulled = pulled || now.force.y() > 0;
        CHECK(now.force.y() >= 0);
        if (machine.scene.world.time < 0.25)
            CHECK(now.force.norm() == 0);
    });
    CHECK(pulled);
    CHECK(longest <= 1 + 1e-9);
    CHECK(longest >= 1 - 1e-6);
    CHECK(machine.scene.world.joints[0].force.y() == doctest::Approx(2 * gravity).epsilon(1e-6));
}

TEST_CASE("joints: a door stops at its limits, on both sides")
{
    for (const double spin : {3.0, -3.0}) {
        Machine machine(0.01, Vec3::Zero());
        const Vec3 omega(0, 0, spin), centre(0.5, 0, 0);
        machine.add_box(Vec3(1, 0.1, 0.1), 1, centre, 0, omega.cross(centre), omega);
        Joint& hinge = machine.add_joint(JointKind::hinge, 0, -1, Vec3::Zero());
        hinge.turn.low = -0.5;
        hinge.turn.high = 0.7;
        machine.run(1);
        CHECK(machine.scene.world.joints[0].angle == doctest::Approx(spin > 0 ? 0.7 : -0.5).epsilon(1e-9));
    }
}

TEST_CASE("joints: a motor lifts with its force until it has its speed, and its work is booked")
{
    Machine machine(0.01);
    machine.add_box(Vec3::Constant(0.2), 10, Vec3::Zero());
    Joint& slider = machine.add_joint(JointKind::slider, 0, -1, Vec3::Zero(), Vec3::UnitY());
    slider.way.motor_speed = 1;
    slider.way.motor_most = 150;
    const double start = energy_of(machine);
    machine.run(0.1);
    const World& world = machine.scene.world;
    CHECK(world.bodies[0]->mean_velocity().y() == doctest::Approx(0.1 * (15 - gravity)).epsilon(1e-9));
    machine.run(0.5);
    CHECK(world.bodies[0]->mean_velocity().y() == doctest::Approx(1).epsilon(1e-6));
    CHECK(world.joints[0].way_force == doctest::Approx(10 * gravity).epsilon(1e-6));
    CHECK(world.driven == doctest::Approx(energy_of(machine) - start).epsilon(1e-6));
}

TEST_CASE("joints: a spring with a damper swings as its formula says, for a short step")
{
    Machine machine(0.001, Vec3::Zero());
    machine.add_box(Vec3::Constant(0.1), 2, Vec3(1.1, 0, 0));
    Joint spring = make_rod(machine.scene.world, "spring", 0, -1, Vec3(1.1, 0, 0), Vec3::Zero());
    spring.way = {};
    spring.way.stiffness = 50;
    spring.way.damping = 2;
    spring.way.rest = 1;
    machine.scene.world.joints.push_back(spring);
    machine.run(0.5);
    const double decay = 2.0 / 4, frequency = std::sqrt(50.0 / 2 - decay * decay);
    const double exact = 1 + 0.1 * std::exp(-decay * 0.5) *
                                 (std::cos(frequency * 0.5) + decay / frequency * std::sin(frequency * 0.5));
    CHECK(machine.scene.world.bodies[0]->centre().x() == doctest::Approx(exact).epsilon(0.002));
}

TEST_CASE("joints: a hinge counts whole turns")
{
    Machine machine(0.01, Vec3::Zero());
    machine.add_box(Vec3(1, 0.1, 0.1), 1, Vec3::Zero(), 0, Vec3::Zero(), Vec3(0, 0, 9));
    machine.add_joint(JointKind::hinge, 0, -1, Vec3::Zero());
    machine.run(2);
    CHECK(machine.scene.world.joints[0].angle == doctest::Approx(18).epsilon(1e-6));
}

TEST_CASE("joints: a weld that carries more than it bears breaks for good, and one that carries less holds")
{
    for (const double bears : {20.0, 19.0}) {
        Machine machine(0.01);
        machine.add_box(Vec3::Constant(0.1), 2, Vec3::Zero());
        machine.add_joint(JointKind::fixed, 0, -1, Vec3::Zero()).breaks_at = bears;
        machine.run(0.5);
        const World& world = machine.scene.world;
        CHECK(world.joints[0].broken == (bears < 2 * gravity));
        CHECK((world.bodies[0]->centre().y() < -0.5) == (bears < 2 * gravity));
    }
}

TEST_CASE("joints: bodies that a joint holds together pass through each other, and by key they do not")
{
    for (const bool touch : {false, true}) {
        Machine machine(0.005);
        machine.add_box(Vec3(1, 0.1, 0.3), 1, Vec3(0.5, 0.06, 0));
        machine.add_box(Vec3(1, 0.1, 0.3), 1, Vec3(0.5, 0.3, 0));
        machine.add_joint(JointKind::fixed, 0, -1, Vec3::Zero());
        machine.add_joint(JointKind::hinge, 1, 0, Vec3(0, 0.18, 0)).bodies_touch = touch;
        machine.run(1.5);
        const double height = machine.scene.world.bodies[1]->centre().y();
        CHECK((height > 0.1) == touch);
    }
}

TEST_CASE(
    "joints: three hinges in a line hold a door with the least forces that do: each a third of its weight")
{
    Machine machine(0.01);
    machine.add_box(Vec3(0.9, 2, 0.04), 30, Vec3(0.45, 1, 0));
    for (const double y : {0.2, 1.0, 1.8})
        machine.add_joint(JointKind::hinge, 0, -1, Vec3(0, y, 0), Vec3::UnitY());
    machine.run(1);
    for (const Joint& joint : machine.scene.world.joints)
        CHECK(joint.force.y() == doctest::Approx(10 * gravity).epsilon(1e-4));
    CHECK(machine.worst_error() <= 1e-9);
}

TEST_CASE("joints: a bar that hangs on a bar with a pin swings without a halved step")
{
    Machine machine(0.005);
    machine.add_bar(Vec3::Zero(), Vec3(0.5, 0, 0), 1);
    machine.add_bar(Vec3(0.5, 0, 0), Vec3(1, 0, 0), 1);
    machine.rigid(0).pin(Vec3::Zero(), Vec3::UnitZ());
    machine.add_joint(JointKind::hinge, 1, 0, Vec3(0.5, 0, 0));
    machine.run(2);
    CHECK(machine.worst_error() <= 1e-9);
    CHECK(machine.scene.world.thrown_away == 0);
}

TEST_CASE("joints: a step that is thrown away leaves no trace in them")
{
    Machine machine = pendulum();
    machine.run(0.3);
    World& world = machine.scene.world;
    Contacts none;
    const SavedState before(world, none);
    const Joint then = world.joints[0];
    machine.run(0.1);
    CHECK(world.joints[0].angle != then.angle);
    before.restore(world, none);
    CHECK(world.joints[0].angle == then.angle);
    CHECK((world.joints[0].lock_force - then.lock_force).norm() == 0);
}
