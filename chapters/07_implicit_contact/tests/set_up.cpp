#include "chapters/07_implicit_contact/step_problem.hpp"
#include "chapters/07_implicit_contact/tests/cube_above_plane.hpp"
#include "chapters/07_implicit_contact/tests/only_island.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/driven_body.hpp"
#include "common/simulation/rigid_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace enduring;
using namespace enduring::chapter07;

TEST_CASE("step problem: a pair slides on where mu_s times its load cannot stop what it carries in this step")
{
    for (const double dt : {0.002, 0.02})
        for (const double part : {0.0, 0.9, 1.1}) {
            const World world = cube_above_plane(0, dt);
            Contacts contacts{corner_on_plane()};
            contacts[0].spring.stiffness = 1e6;
            contacts[0].spring.load = 80;
            contacts[0].spring.slip = part * 0.5 * 80 * dt / corner_mass;
            const StepProblem step = set_up_only_island(world, contacts, {}, {0.5, 0.1}, {1, dt}, true);
            REQUIRE(step.problem.rows.size() == 1);
            CAPTURE(dt);
            CAPTURE(part);
            CHECK(step.problem.rows[0].law.mu == (part > 1 ? 0.1 : 0.5));
        }
}

TEST_CASE("step problem: a pair that began inside rubs when it is nearly out, by the size of its body")
{
    constexpr double dt = 0.004;
    StiffnessChoice choice;
    for (const double size : {0.1, 1.0, 10.0})
        for (const double part : {0.9, 1.1}) {
            const World world = cube_above_plane(-size / 10, dt, size);
            Contacts contacts{corner_on_plane()};
            contacts[0].spring.stiffness = 1e6;
            contacts[0].spring.rest_offset = -part * 100 * scale_parts.wanted_depth * world.bodies[0]->size();
            const StepProblem step = set_up_only_island(world, contacts, choice, {0.5, 0.4}, {1, dt}, false);
            CAPTURE(size);
            CHECK(step.problem.rows.at(0).law.mu == (part < 1 ? 0.5 : 0));
        }
}

TEST_CASE("step problem: a pair that holds does not slip, however it moves")
{
    const double dt = 0.004;
    const World world = cube_above_plane(-1e-4, dt);
    Contacts contacts{corner_on_plane()};
    contacts[0].spring.stiffness = 1e3;
    contacts[0].spring.slip = 3;
    StepProblem step = set_up_only_island(world, contacts, {}, {0.5, 0.4}, {1, dt}, false);
    step.problem.rows.at(0).law.lagged_normal_impulse = 1;
    step.problem.rows.at(0).velocity = Vec3(0.01, 0, 0);
    find_slip(step);
    CHECK(contacts[0].spring.slip == 0);
}

TEST_CASE("step problem: the most load is ten times all weight and what stops all motion in the step")
{
    for (const double dt : {0.002, 0.02}) {
        World world = cube_above_plane(0, dt, 1, Vec3(3, 0, 4));
        const SurfaceMesh mesh = box(Vec3::Ones());
        world.bodies.push_back(
            std::make_unique<RigidBody>("cube", mesh, with_mass(mass_properties(mesh, 1), 7), Vec3(0, 2, 0)));
        world.gravity = Vec3(0, -3, 4);
        CHECK(max_load(world, {{0, 1}, {}}, dt) == doctest::Approx(10 * 5 * 17 + (10 * 5 + 7 * 2) / dt));
    }
}

TEST_CASE(
    "step problem: forces and torques from outside count ten times, a torque at the arm of the body's size")
{
    for (const double dt : {0.002, 0.02}) {
        World world = cube_above_plane(0, dt, 2);  // of 10 kg, without weight
        auto& cube = dynamic_cast<RigidBody&>(*world.bodies[0]);
        cube.add_load({.force = TimedVector(Vec3(0, 3, -4)), .torque = TimedVector(Vec3(6, 0, 8))});
        cube.predict(world.gravity, dt);
        CAPTURE(dt);
        CHECK(max_load(world, {{0}, {}}, dt) == doctest::Approx(10 * (5 + 10 / 2.0) + 5));
    }
}

TEST_CASE(
    "step problem: a pull on a soft body that is held counts ten times, and what its elements do at both ends")
{
    World world;
    world.gravity.setZero();
    const TetrahedralMesh mesh = bar(Vec3(2, 0.5, 0.25), {4, 1, 1});
    DeformableSettings soft;
    soft.material = {1e5, 0, 1000};
    std::vector<NodeWeight> pulled;
    for (int node = 0; node < static_cast<int>(mesh.nodes.size()); ++node) {
        const double x = mesh.nodes[static_cast<std::size_t>(node)].x();
        if (x < -0.99)
            soft.fixed_nodes.push_back(node);
        if (x > 0.99)
            pulled.push_back({node, 0.25});
    }
    auto body = std::make_unique<DeformableBody>("soft", mesh, soft);
    body->add_force(TimedVector(Vec3(30, 0, 0)), pulled);
    world.bodies.push_back(std::move(body));
    Contacts contacts;
    for (int step = 0; step < 100; ++step)
        advance(world, contacts, Solver{"", {}, {}, {}}, 0.1);
    CHECK(max_load(world, {{0}, {}}, 0.1) == doctest::Approx(10 * (30 + 30 + 30)).epsilon(0.02));
}

TEST_CASE(
    "step problem: an enduring pair is as stiff as its mass and its load ask for, but holds no more than others can bring")
{
    const double dt = 0.004;
    const World world = cube_above_plane(-1e-4, dt);
    StiffnessChoice choice;
    choice.wanted_depth = 1e-5;
    for (const double load : {5.0, 1000.0})
        for (const double before : {1e6, 1e9}) {
            Contacts contacts{corner_on_plane()};
            contacts[0].spring.stiffness = before;
            contacts[0].spring.rest_offset = -1e-4 + load / before;
            contacts[0].spring.load = load;
            set_up_only_island(world, contacts, choice, {}, {1, dt}, true);
            CAPTURE(load);
            CAPTURE(before);
            const double of_mass = 100 * corner_mass / (dt * dt);  // 156 N for the wanted depth
            // what is pressed harder than others can press it is made no stiffer
            const double most = std::max(before, max_load(world, {{0}, {}}, dt) * before / load);
            CHECK(contacts[0].spring.stiffness ==
                  doctest::Approx(std::min(std::max(of_mass, load / 1e-5), most)).epsilon(1e-3));
        }
}

TEST_CASE(
    "pair motion: over a bend a pair is pushed along the mean of where it came from and the normal of its path")
{
    constexpr double dt = 0.004;
    const Vec3 came(std::sin(0.1), std::cos(0.1), 0), ends = Vec3::UnitY();
    const auto pushed_along = [&](const Vec3& velocity) {
        const World world = cube_above_plane(0, dt, 1, velocity);
        Contact contact = corner_on_plane();
        contact.sliding_normal = came;
        PairRow row;
        update_row(world, contact, {1, dt}, row);
        return row.law.normal;
    };
    const Vec3 slides = Vec3(1, -0.03, 0);
    CHECK((pushed_along(slides) - (came + Vec3(0.03, 1, 0).normalized()).normalized()).norm() < 1e-12);
    // what leaves both, or comes down on both, meets the one along which it moves less
    CHECK((pushed_along(Vec3(-0.1, 1, 0)) - came).norm() < 1e-12);
    CHECK((pushed_along(Vec3(0.1, 1, 0)) - (came + ends).normalized()).norm() < 1e-12);
    CHECK((pushed_along(Vec3(0.1, -1, 0)) - came).norm() < 1e-12);
    CHECK((pushed_along(Vec3(-0.1, -1, 0)) - (came + ends).normalized()).norm() < 1e-12);
    CHECK(pushed_along(Vec3::Zero()).norm() == doctest::Approx(1));
}

TEST_CASE("step problem: a vertex that several pairs touch is touched once")
{
    World world = cube_above_plane(0, 0.01);
    world.planes.push_back({"wall", Vec3(-9, 0, 0), Vec3::UnitX()});
    Contacts contacts{corner_on_plane(5), corner_on_plane(2), corner_on_plane(5)};
    contacts[2].body_b = 1;
    CHECK(set_up_only_island(world, contacts, {}, {}, {1, 0.01}, true).vertices[0] == std::vector{2, 5});
}

TEST_CASE("step problem: a limit of friction is taken from what acts along the normal, and is never negative")
{
    const double dt = 0.004;
    const World world = cube_above_plane(-1e-4, dt);
    for (const double along : {4.0, -4.0}) {
        Contacts contacts{corner_on_plane()};
        contacts[0].spring.stiffness = 1e6;
        StepProblem step = set_up_only_island(world, contacts, {}, {0.5, 0.4}, {1, dt}, true);
        contacts[0].impulse = Vec3(3, along, 0);
        update_kinematics(world, step);
        CHECK(step.problem.rows.at(0).law.lagged_normal_impulse == std::max(0.0, along));
    }
}

TEST_CASE(
    "step problem: last impulses are load and stretch over this step's length, by the normal of its start")
{
    for (const double dt : {0.002, 0.02}) {
        World world = cube_above_plane(0, dt);
        world.bodies.push_back(
            std::make_unique<DrivenBody>("drum", box(Vec3::Ones()), Vec3::Zero(),
                                         GivenMotion::steady(Vec3::Zero(), Vec3(0, 0, 0.3 / dt))));
        world.bodies[1]->predict(Vec3::Zero(), dt);
        const auto& faces = world.bodies[1]->surface().faces();
        const auto at = [&](int v) { return world.bodies[1]->positions_t0()[static_cast<std::size_t>(v)]; };
        for (int face = 0; face < 12; ++face) {
            const auto [f0, f1, f2] = faces[face];
            Contact pair{ContactKind::vertex_face, 0, 1, 0, face, {0, f0, f1, f2}, {1, -0.5, -0.25, -0.25}};
            pair.spring.stiffness = 1e5;
            pair.spring.load = 30;
            pair.spring.stretch = Vec3(1e-5, 2e-5, -3e-5);
            Contacts contacts{pair};
            const StepProblem step = set_up_only_island(world, contacts, {}, {0.5, 0.4}, {1, dt}, false);
            const Vec3 normal = (at(f1) - at(f0)).cross(at(f2) - at(f0)).normalized();
            CHECK((last_impulses(world, step) - dt * (30 * normal - 1e5 * pair.spring.stretch)).norm() <
                  1e-12);
        }
    }
}
