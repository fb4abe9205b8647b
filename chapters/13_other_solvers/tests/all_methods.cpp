#include "chapters/13_other_solvers/tests/small_scenes.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/input/input_error.hpp"
#include "common/simulation/deformable_body.hpp"

#include <doctest/doctest.h>

#include <map>
#include <numbers>
#include <string>

using namespace enduring;

namespace {

/// Two cubes that meet at an angle, without gravity and ground.
Scene collision()
{
    Scene scene = chapter07::scene_of(
        {{10, Vec3(0, 0, 0), 20, Vec3(1, 2, 3).normalized(), Vec3::Ones(), Vec3(1, 0, 2)},
         {40, Vec3(1.6, 0.3, 0.2), 50, Vec3(3, 1, 2).normalized()}},
        0.01, 0, 0, 0);
    scene.world.planes.clear();
    scene.world.gravity.setZero();
    scene.world.bodies[0]->kick({}, (Eigen::VectorXd(6) << 30, 5, 0, 0, 0, 0).finished(), 0.01);
    return scene;
}

}  // namespace

TEST_CASE("other solvers: the impulses of a cube at rest carry its weight")
{
    for (const OtherMethod& method : other_methods()) {
        CAPTURE(method.name);
        Scene scene = one_cube();
        Contacts contacts;
        run(scene, method.make(scene.contact), 2, contacts);
        CHECK((sum_of(contacts) - Vec3(0, 10 * 9.81 * scene.dt, 0)).norm() <= 2e-4);
        CHECK(std::abs(scene.world.bodies[0]->centre().y() - 0.5) <= 0.0055);  // the slop is the largest
    }
}

TEST_CASE(
    "other solvers: a cube on a slope below the angle of friction stays, but for a creep that is bounded")
{
    const std::map<std::string, double> creep{{"sequential", 1e-6}, {"soft_step", 2e-3}, {"relaxation", 1e-4},
                                              {"xpbd", 5e-3},       {"avbd", 3e-3},      {"barrier", 1e-3}};
    for (const OtherMethod& method : other_methods()) {
        CAPTURE(method.name);
        Scene scene = one_cube(0, 20);
        const Solver solver = method.make(scene.contact);
        run(scene, solver, 1);
        const Vec3 from = scene.world.bodies[0]->centre();
        run(scene, solver, 2);
        CHECK((scene.world.bodies[0]->centre() - from).norm() / 2 <= creep.at(method.name));
    }
}

TEST_CASE("other solvers: a cube that slides down has the acceleration of Coulomb's law, in XPBD too little")
{
    const double angle = 50 * std::numbers::pi / 180, law = 9.81 * (std::sin(angle) - 0.5 * std::cos(angle));
    for (const OtherMethod& method : other_methods()) {
        CAPTURE(method.name);
        Scene scene = one_cube(0, 50);
        const Solver solver = method.make(scene.contact);
        run(scene, solver, 1);
        const double before = scene.world.bodies[0]->mean_velocity().norm();
        run(scene, solver, 1);
        const double found = scene.world.bodies[0]->mean_velocity().norm() - before;
        CHECK(found == doctest::Approx(law).scale(0).epsilon(method.name == "xpbd" ? 0.15 : 2e-3));
    }
}

TEST_CASE(
    "other solvers: a collision keeps momentum, in AVBD as far as its sweeps converge, and brings no energy")
{
    for (const OtherMethod& method : other_methods()) {
        CAPTURE(method.name);
        Scene scene = collision();
        const auto sum = [&](const auto& of) {
            return Vec3(of(*scene.world.bodies[0]) + of(*scene.world.bodies[1]));
        };
        const auto linear = [](const Body& body) { return body.linear_momentum(); };
        const auto turning = [](const Body& body) { return body.angular_momentum(Vec3::Zero()); };
        const auto kinetic = [&] {
            return scene.world.bodies[0]->energy(Vec3::Zero()).kinetic +
                   scene.world.bodies[1]->energy(Vec3::Zero()).kinetic;
        };
        const Vec3 linear_t0 = sum(linear), turning_t0 = sum(turning);
        const double kinetic_t0 = kinetic();
        run(scene, method.make(scene.contact), 0.5);
        const bool is_avbd = method.name == "avbd";  // each body is pushed by what it has found itself
        CHECK((sum(linear) - linear_t0).norm() <= (is_avbd ? 1e-2 : 1e-9) * linear_t0.norm());
        // p and q leave each other along the surface within a step, and with them the lines on which they are
        // pushed
        const bool is_velocity = method.name == "sequential" || method.name == "relaxation";
        // the barrier pushes at levers of the step's end, from where bodies have gone along by their old
        // velocities
        const double off = is_velocity ? 0.02 : method.name == "barrier" ? 0.1 : 0.06;
        CHECK((sum(turning) - turning_t0).norm() <= off * turning_t0.norm());
        CHECK(kinetic() < 0.9 * kinetic_t0);  // they have met
    }
}

TEST_CASE(
    "other solvers: those that know restitution send a cube on its corner back by its coefficient, the others do not")
{
    for (const OtherMethod& method : other_methods()) {
        CAPTURE(method.name);
        const double up = std::acos(1 / std::sqrt(3.0)) * 180 / std::numbers::pi;  // a diagonal is vertical
        Scene scene = chapter07::scene_of(
            {{10, Vec3(0, std::sqrt(0.75) + 0.5, 0), up, Vec3(-1, 0, 1).normalized()}}, 0.01);
        scene.world.restitution.between = {0.6};
        const Solver solver = method.make(scene.contact);
        double fastest_up = 0;
        Contacts contacts;
        for (int step = 0; step < 50; ++step) {
            advance(scene.world, contacts, solver, scene.dt);
            fastest_up = std::max(fastest_up, scene.world.bodies[0]->mean_velocity().y());
        }
        const double touch = std::sqrt(2 * 9.81 * 0.5);
        const bool bounces = method.name == "sequential" || method.name == "soft_step" ||
                             method.name == "xpbd";
        if (bounces)
            CHECK(fastest_up == doctest::Approx(0.6 * touch).scale(0).epsilon(0.06));
        else
            CHECK(fastest_up <= 0.3);  // what lets out what has come in
    }
}

TEST_CASE(
    "other solvers: a body that is not rigid and free is refused by its name, and so is a method that is not there")
{
    Scene scene = one_cube();
    DeformableSettings settings;
    settings.position = Vec3(3, 1, 0);
    scene.world.bodies.push_back(
        std::make_unique<DeformableBody>("jelly", bar(Vec3::Ones(), {1, 1, 1}), settings));
    Contacts contacts;
    CHECK_THROWS_WITH_AS(
        advance(scene.world, contacts, chapter13_solver("sequential", scene.contact), scene.dt),
        "body 'jelly' is deformable; this solver moves rigid bodies only", InputError);
    CHECK_THROWS_WITH_AS(
        chapter13_solver("magic", scene.contact),
        "no method 'magic'; there are sequential, soft_step, relaxation, xpbd, avbd, barrier", InputError);
}
