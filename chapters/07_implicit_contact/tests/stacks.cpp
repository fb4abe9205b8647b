#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/implicit_contact.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "common/simulation/rigid_body.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <utility>

using namespace enduring;
using namespace enduring::chapter07;

TEST_CASE("stack: ten cubes stand, each joint within a tenth of a millimetre, and gain no energy")
{
    for (const double dt : {0.01, 1.0 / 60}) {
        Scene scene = scene_of(stack_of(10), dt);
        const PileOutcome outcome = watch(scene, 3, chapter07_solver);
        CHECK(outcome.deepest_mm < 0.1);
        CHECK(outcome.deepest_mm > 1e-6);
        CHECK(outcome.drift_um_per_s < 1);
        CHECK(outcome.energy_gain_j <= 1e-9);
        CHECK(outcome.newton_steps_at_rest <= 2);
        CHECK(scene.world.bodies.back()->centre().y() == doctest::Approx(9.5).epsilon(1e-4));
    }
}

TEST_CASE("stack: a ton on a kilogram and a kilogram on a ton rest alike")
{
    for (const auto& [below, above] : {std::pair(1.0, 1000.0), std::pair(1000.0, 1.0)}) {
        Scene scene = scene_of(stack_of(2, below, above), 0.01);
        const PileOutcome outcome = watch(scene, 2, chapter07_solver);
        CHECK(outcome.deepest_mm < 0.1);
        CHECK(outcome.drift_um_per_s < 1);
        CHECK(outcome.energy_gain_j <= 1e-9);
        CHECK(outcome.solves.unconverged == 0);
    }
}

TEST_CASE("slope: a cube holds 1 % above tan and slides 1 % below, at every angle")
{
    for (const double angle : {5.0, 30.0})
        for (const double part : {0.99, 1.01}) {
            const double mu = part * std::tan(angle * 3.14159265358979 / 180);
            Scene scene = scene_of({{10, Vec3(0, 0.5, 0), 0}}, 0.01, angle, mu, mu);
            const Solver solver = chapter07_solver(scene.contact);
            Contacts contacts;
            for (int i = 0; i < 100; ++i)
                advance(scene.world, contacts, solver, scene.dt);
            CHECK((std::abs(scene.world.bodies[0]->centre().x()) < 1e-4) == (part > 1));
        }
}

TEST_CASE(
    "rigid coordinates: the same impulse at a vertex changes the body as its own impulse does, with the lever of the start")
{
    const Scene one = scene_of(stack_of(1), 0.01), other = scene_of(stack_of(1), 0.01);
    auto& mine = dynamic_cast<RigidBody&>(*one.world.bodies[0]);
    auto& its = dynamic_cast<RigidBody&>(*other.world.bodies[0]);
    const std::vector<int> touched{3};
    const Vec3 impulse(0.3, -2, 1);
    const VertexMotion motion = mine.contact_motion(touched, 0, 0);
    mine.apply_contact_impulse(touched, motion.rate.transpose() * impulse);
    its.apply_impulse(3, impulse);
    CHECK((mine.velocity(3) - its.velocity(3)).norm() <= 1e-14);
    CHECK((mine.motion().angular_velocity() - its.motion().angular_velocity()).norm() <= 1e-14);
    const Eigen::MatrixXd response = motion.rate * mine.contact_mass(touched).response *
                                     motion.rate.transpose();
    CHECK((response - mine.inverse_mass(3)).norm() <= 1e-12);
}

TEST_CASE("slope: a cube that slides does so with g (sin - mu_d cos), whatever held it before")
{
    Scene scene = scene_of({{10, Vec3(0, 0.5, 0), 0}}, 0.01, 20, 0.3, 0.1);
    const Solver solver = chapter07_solver(scene.contact);
    Contacts contacts;
    const auto speed_after = [&](int steps) {
        for (int i = 0; i < steps; ++i)
            advance(scene.world, contacts, solver, scene.dt);
        return -scene.world.bodies[0]->mean_velocity().x();
    };
    const double first = speed_after(50), second = speed_after(100), angle = 20 * 3.14159265358979 / 180;
    CHECK(second - first == doctest::Approx(9.81 * (std::sin(angle) - 0.1 * std::cos(angle))).epsilon(0.002));
}

TEST_CASE(
    "slope: at rest the last step's impulses are the answer, friction with them, so no step needs two rounds")
{
    Scene scene = scene_of({{10, Vec3(0, 0.5, 0), 0}}, 0.01, 20);
    long rounds = 0;
    ImplicitSettings settings;
    settings.record = [&](const SolveRecord& record) { rounds += record.rounds; };
    const Solver solver = chapter07_solver(scene.contact, settings);
    Contacts contacts;
    for (int i = 0; i < 99; ++i)
        advance(scene.world, contacts, solver, scene.dt);
    CHECK(rounds <= 99);
}

TEST_CASE(
    "implicit contact: a second solve in a step leaves the pairs' stiffness and rest offset as they are")
{
    Scene scene = scene_of({{10, Vec3(0, 0.49, 0), 0}}, 0.01);
    scene.world.bodies[0]->predict(scene.world.gravity, scene.dt);
    Contacts contacts{{ContactKind::vertex_plane, 0, 0, 0, -1, {0, -1, -1, -1}, {1, 0, 0, 0}}};
    contacts[0].spring.stiffness = 1e5;
    contacts[0].spring.rest_offset = -5e-3;
    contacts[0].spring.load = 1e9;
    IslandMatrices matrices;
    ImplicitSettings settings;
    settings.record = [](const SolveRecord&) {};
    solve_contacts(scene.world, contacts, settings, matrices, scene.dt);
    const double stiffness = contacts[0].spring.stiffness, rest_offset = contacts[0].spring.rest_offset;
    CHECK(stiffness > 1e5);
    CHECK(rest_offset != -5e-3);
    contacts.push_back({ContactKind::vertex_plane, 0, 0, 1, -1, {1, -1, -1, -1}, {1, 0, 0, 0}});
    solve_contacts(scene.world, contacts, settings, matrices, scene.dt);
    CHECK(contacts[0].spring.stiffness == stiffness);
    CHECK(contacts[0].spring.rest_offset == rest_offset);
    CHECK(contacts[1].spring.stiffness > 0);
}

TEST_CASE(
    "implicit contact: an impulse turns a body with the lever of the place where it acts, at the step's end")
{
    Scene scene = scene_of({{10, Vec3(0, 0.8, 0), 30, Vec3(1, 0.3, 0.2).normalized()}}, 0.01);
    auto& cube = dynamic_cast<RigidBody&>(*scene.world.bodies[0]);
    cube.apply_impulse(0, Vec3(8, -30, 5));
    const Solver solver = chapter07_solver(scene.contact);
    Contacts contacts;
    int hits = 0;
    for (int i = 0; i < 60; ++i) {
        const Vec3 spin = cube.angular_momentum(cube.centre());
        const Quaternion before = cube.motion().pose().orientation;
        const std::vector<Vec3> start(cube.positions_t0().begin(), cube.positions_t0().end());
        const Vec3 centre = cube.centre();
        advance(scene.world, contacts, solver, scene.dt);
        const Quaternion by = cube.motion().pose().orientation * before.conjugate();
        Vec3 expected = spin;
        double moved = 0;
        for (const Contact& contact : contacts) {
            // The lever that all its pushes have is that of the motion found, as near as the solve follows
            // it.
            const Vec3 lever = by * (start[static_cast<std::size_t>(contact.vertices[0])] - centre);
            expected += lever.cross(contact.impulse + contact.friction);
            moved += ImplicitSettings{}.lever_turn * lever.norm() * contact.impulse.norm();
            hits += !contact.impulse.isZero();
        }
        CHECK((cube.angular_momentum(cube.centre()) - expected).norm() <= moved + 1e-9);
    }
    CHECK(hits > 10);
}
