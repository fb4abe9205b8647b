#include "chapters/12_joints/experiments/crane_scene.hpp"
#include "chapters/12_joints/experiments/machine.hpp"
#include "chapters/12_joints/experiments/rope_over_edge.hpp"
#include "chapters/12_joints/experiments/walking.hpp"
#include "common/simulation/contact_forces.hpp"
#include "common/simulation/energy.hpp"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace enduring;
using namespace enduring::chapter12;

TEST_CASE("Watt's linkage: the middle of its coupler stays on Watt's curve")
{
    const double b = 1, c = 0.25, a = std::hypot(b, c);
    const Vec3 pin(a, 0, 0), end = c * Vec3(c / a, b / a, 0);
    Machine machine(0.01);
    const int right = machine.add_bar(pin, end, 1), coupler = machine.add_bar(end, -end, 1),
              left = machine.add_bar(-pin, -end, 1);
    Joint& driven = machine.add_joint(JointKind::hinge, right, -1, pin);
    driven.turn.motor_speed = 0.5;
    driven.turn.motor_most = 1e3;
    machine.add_joint(JointKind::hinge, coupler, right, end);
    machine.add_joint(JointKind::hinge, coupler, left, -end);
    machine.add_joint(JointKind::hinge, left, -1, -pin);
    double farthest = 0;
    machine.run(1, [&] {
        const Vec3 middle = machine.scene.world.bodies[1]->centre();
        const double angle = std::atan2(middle.y(), middle.x()),
                     root = std::sqrt(c * c - std::pow(a * std::cos(angle), 2));
        const double far = std::sqrt(b * b - std::pow(a * std::abs(std::sin(angle)) - root, 2));
        if (middle.norm() > 0.1)  // the polar form is ill-conditioned in the middle
            CHECK(middle.norm() == doctest::Approx(far).epsilon(1e-9));
        farthest = std::max(farthest, middle.norm());
    });
    CHECK(farthest > 0.4);
    CHECK(machine.worst_error() <= 1e-9);
}

TEST_CASE("rope: over an edge it holds a pull below its largest ratio, and slides above it")
{
    for (const RopeOverEdge& rope : {RopeOverEdge{.angle = std::numbers::pi, .links = 6, .mu = 0.3},
                                     RopeOverEdge{.angle = std::numbers::pi / 2, .links = 6, .mu = 0.5}}) {
        CAPTURE(rope.mu);
        CHECK(pull_rope(rope, 0.98 * largest_ratio(rope), 0.3).displacement < 1e-5);
        CHECK(pull_rope(rope, 1.02 * largest_ratio(rope), 0.3).displacement > 1e-3);
    }
}

TEST_CASE("rope: with many links its largest ratio is Euler's")
{
    const RopeOverEdge fine{.angle = 2, .links = 10000, .mu = 0.4};
    CHECK(largest_ratio(fine) == doctest::Approx(std::exp(0.8)).epsilon(1e-8));
}

TEST_CASE("crane: a slab carries what the rope does not, and sinks by it")
{
    const double weight = crane_statics::load * crane_statics::gravity;
    for (const double part : {0.5, 1.5}) {
        CAPTURE(part);
        const double share = std::min(part, 1.0);
        const CraneRun run = run_crane(crane_statics::way_down + part * crane_statics::sag, 6);
        CHECK(run.hanging.rope == doctest::Approx(weight).epsilon(1e-3));
        CHECK(run.hanging.slab == 0);
        CHECK(run.hanging.moment == doctest::Approx(crane_statics::moment).epsilon(1e-3));
        CHECK(std::abs(run.end.rope - (1 - share) * weight) <= 1e-3 * weight);
        CHECK(run.end.slab == doctest::Approx(share * weight).epsilon(1e-3));
        CHECK(run.end.ground ==
              doctest::Approx(share * weight + crane_statics::slab * crane_statics::gravity).epsilon(1e-3));
        const double sag = crane_statics::height - crane_statics::own_sag - run.end.top;
        CHECK(sag == doctest::Approx(share * crane_statics::sag).epsilon(1e-2));
        CHECK(run.swing < 0.1 * run.most);  // the trolley ran for one period
        CHECK(run.error <= 1e-9);
        CHECK(run.bad == 0);
    }
}

TEST_CASE("walker: the turns of a leg bring its foot to its place, level")
{
    for (const Vec3& foot : {Vec3(0.1, -0.55, 0.03), Vec3(-0.08, -0.5, -0.05), Vec3(0, -0.59, 0)}) {
        const auto [roll, hip, knee, ankle, ankle_roll] = leg_turns(foot);
        const auto about = [](double angle, const Vec3& axis) {
            return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
        };
        const Mat3 thigh = about(roll, Vec3::UnitX()) * about(hip, Vec3::UnitZ()),
                   shank = thigh * about(knee, Vec3::UnitZ());
        const Vec3 reached = thigh * Vec3(0, -Walker::thigh, 0) + shank * Vec3(0, -Walker::shank, 0);
        CHECK((reached - foot).norm() <= 1e-12);
        const Mat3 level = shank * about(ankle, Vec3::UnitZ()) * about(ankle_roll, Vec3::UnitX());
        CHECK((level - Mat3::Identity()).norm() <= 1e-12);
        CHECK(knee <= 0);
    }
}

TEST_CASE("walker: it stays up and whole on its way, the ground carries its weight, and its work is booked")
{
    const Gait gait;
    Walker walker(gait);
    const World& world = walker.machine.scene.world;
    REQUIRE(world.bodies.size() == Walker::bodies);
    const Vec3 start = walker.hips().centre();
    const auto own_energy = [&] { return total_energy(world).total() - world.driven; };
    const double first = own_energy();
    double pushed = 0, worst = 0;
    walker.walk(4.8, [&] {
        worst = std::max(worst, (walker.hips().centre() - start - gait.hips(world.time)).norm());
        if (world.step == 155)  // it stands on both feet, with bent knees
            for (const Contact& contact : walker.contacts())
                pushed += pair_force(contact, last_part(world, walker.machine.scene.dt)).normal.y();
    });
    CHECK(worst <= 1e-4);
    CHECK(walker.hips().centre().x() - start.x() > 0.35);
    CHECK(walker.joint_error() <= 1e-9);
    CHECK(pushed == doctest::Approx(9.81 * walker.mass()).epsilon(0.01));
    CHECK(own_energy() < first);
    CHECK(world.thrown_away == 0);  // motors that lift the whole machine from the ground gain no energy
}
