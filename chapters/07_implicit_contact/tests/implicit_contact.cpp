#include "chapters/07_implicit_contact/implicit_contact.hpp"
#include "chapters/05_categorisation/normal_span.hpp"
#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "chapters/07_implicit_contact/tests/cube_above_plane.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/driven_body.hpp"
#include "common/simulation/rigid_body.hpp"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

using namespace enduring;
using namespace enduring::chapter07;

TEST_CASE(
    "implicit contact: what springs hold where the bodies begin, more than was booked for them, is put in")
{
    for (const double dt : {0.002, 0.02}) {
        World world = cube_above_plane(-1e-4, dt);
        world.attempt.springs = 5;
        const std::vector<int> lower = lower_corners(*world.bodies[0]);
        Contacts contacts{corner_on_plane(lower[0]), corner_on_plane(lower[1])};
        contacts[0].spring.stiffness = contacts[1].spring.stiffness = 1e10;
        contacts[0].spring.load = contacts[1].spring.load = 1e5;  // asks for as much
        contacts[0].spring.rest_offset = -4e-5;
        contacts[1].spring.rest_offset = -3e-4;  // not compressed
        contacts[1].spring.stretch = Vec3(2e-5, 0, 0);
        ImplicitSettings settings;
        settings.stiffness.keep = 1;
        settings.stiffness.k_dt2_over_m = 1e-6;
        settings.max_newton_steps = 0;
        settings.record = [](const SolveRecord&) {};
        IslandMatrices matrices;
        solve_contacts(world, contacts, settings, matrices, dt);
        REQUIRE(contacts[0].spring.rest_offset == doctest::Approx(-4e-5));
        CHECK(world.attempt.added_energy == doctest::Approx(1e10 / 2 * (6e-5 * 6e-5 + 2e-5 * 2e-5) - 5));
    }
}

TEST_CASE("implicit contact: a later response of the step books no spring again")
{
    constexpr double dt = 0.004;
    World world = cube_above_plane(-1e-4, dt);
    world.attempt.springs = 5;
    const std::vector<int> lower = lower_corners(*world.bodies[0]);
    Contacts contacts{corner_on_plane(lower[0])};
    contacts[0].spring.stiffness = 1e6;
    ImplicitSettings settings;
    settings.record = [](const SolveRecord&) {};
    IslandMatrices matrices;
    solve_contacts(world, contacts, settings, matrices, dt);
    const double added_energy = world.attempt.added_energy;
    CHECK(added_energy < -4);
    contacts.push_back(corner_on_plane(lower[1]));
    solve_contacts(world, contacts, settings, matrices, dt);
    CHECK(contacts[1].answered());
    CHECK(world.attempt.added_energy == added_energy);
}

TEST_CASE("implicit contact: a step is solved as well as its worst island is, whichever place that has")
{
    constexpr double dt = 0.004;
    for (const int falls : {0, 1})
        for (const int max_newton_steps : {0, 500}) {
            World world;
            world.gravity.setZero();
            world.planes.push_back({"ground"});
            Contacts contacts;
            for (const int i : {0, 1}) {
                SurfaceMesh mesh = box(Vec3::Ones());
                for (Vec3& x : mesh.vertices)
                    x += Vec3(5 * i, 0.5 + 1e-9, 0);
                world.bodies.push_back(std::make_unique<RigidBody>("cube", mesh, mass_properties(mesh, 10),
                                                                   Vec3(0, i == falls ? -1 : 0, 0)));
                world.bodies.back()->predict(world.gravity, dt);
                for (const int vertex : lower_corners(*world.bodies.back())) {
                    contacts.push_back(corner_on_plane(vertex));
                    contacts.back().body_a = i;
                }
            }
            SolveRecord last;
            ImplicitSettings settings;
            settings.max_newton_steps = max_newton_steps;
            settings.record = [&](const SolveRecord& record) { last = record; };
            IslandMatrices matrices;
            solve_contacts(world, contacts, settings, matrices, dt);
            CAPTURE(falls);
            CHECK(last.islands == 2);
            CHECK(last.converged == (max_newton_steps > 0));
            CHECK((last.residual == doctest::Approx(1)) == (max_newton_steps == 0));
            CHECK((last.rounds > 0) == (max_newton_steps > 0));
            CHECK((last.newton_steps > 0) == (max_newton_steps > 0));
        }
}

TEST_CASE("implicit contact: a spring is pressed too far by the size of its body, in a step of any length")
{
    for (const double dt : {0.002, 0.02})
        for (const double size : {1.0, 0.1}) {
            World world = cube_above_plane(1e-9, dt, size, Vec3(0, -0.2 / dt, 0));  // ends 2 mm deep
            world.attempt.may_be_halved = true;
            Contacts contacts;
            for (const int vertex : lower_corners(*world.bodies[0]))
                contacts.push_back(corner_on_plane(vertex));
            IslandMatrices matrices;
            solve_contacts(world, contacts, {}, matrices, dt);
            CAPTURE(dt);
            CAPTURE(size);
            CHECK(world.attempt.trouble == (size < 1 ? StepTrouble::too_deep : StepTrouble::none));
        }
}

TEST_CASE(
    "implicit contact: a pair that is held stays so when the others are answered, and nothing is told of what is thrown away")
{
    for (const bool may_be_halved : {true, false}) {
        const double dt = 0.004;
        World world = cube_above_plane(1e-9, dt, 0.1, Vec3(0, -0.2 / dt, 0));
        world.attempt.may_be_halved = may_be_halved;
        Contacts contacts;
        for (int vertex = 0; vertex < 8; ++vertex)
            contacts.push_back(corner_on_plane(vertex));
        const int upper = 8 - 1 - lower_corners(*world.bodies[0])[0];  // across the cube
        contacts[static_cast<std::size_t>(upper)].hold(true);
        int told = 0;
        ImplicitSettings settings;
        settings.record = [&](const SolveRecord&) { ++told; };
        IslandMatrices matrices;
        solve_contacts(world, contacts, settings, matrices, dt);
        for (int vertex = 0; vertex < 8; ++vertex) {
            const Contact& contact = contacts[static_cast<std::size_t>(vertex)];
            CHECK((vertex == upper ? contact.held() : contact.answered()));
        }
        CHECK(world.attempt.trouble == StepTrouble::too_deep);
        CHECK(told == !may_be_halved);
    }
}

TEST_CASE("implicit contact: what nothing moves and nothing presses is solved at once, without gravity, too")
{
    World world = cube_above_plane(-1e-3, 0.004);
    Contacts contacts{corner_on_plane(lower_corners(*world.bodies[0])[0])};
    SolveRecord last;
    ImplicitSettings settings;
    settings.record = [&](const SolveRecord& record) { last = record; };
    IslandMatrices matrices;
    solve_contacts(world, contacts, settings, matrices, 0.004);  // begins inside: its spring is slack
    CHECK(last.converged);
    CHECK(last.residual == 0);
    CHECK(last.newton_steps == 0);
}

TEST_CASE(
    "pair memory: load and stretch are forces, whatever the length of the step, and the stretch turns with the surface")
{
    for (const double dt : {0.002, 0.02})
        for (const double turn : {0.0, 0.2}) {
            World world = cube_above_plane(0, dt);
            world.bodies.push_back(
                std::make_unique<DrivenBody>("table", box(Vec3(2, 1, 2)), Vec3::Zero(),
                                             GivenMotion::steady(Vec3::Zero(), Vec3(0, turn / dt, 0))));
            world.bodies[1]->predict(Vec3::Zero(), dt);
            int face = 0;
            while (surface_at(*world.bodies[1], 0).face_normal(face).normalized().y() < 0.999)
                ++face;
            const auto [f0, f1, f2] = world.bodies[1]->surface().faces()[face];
            Contact pair{ContactKind::vertex_face, 0, 1, 0, face, {0, f0, f1, f2}, {1, -0.5, -0.25, -0.25}};
            pair.spring.stiffness = 1e5;
            pair.impulse = dt * Vec3(0, 30, 0);
            pair.friction = dt * Vec3(3, 0, -4);
            Contacts contacts{pair};
            remember_pairs(world, contacts, dt);
            CAPTURE(dt);
            CAPTURE(turn);
            CHECK(contacts[0].spring.load == doctest::Approx(30));
            const Vec3 expected = Eigen::AngleAxisd(turn, Vec3::UnitY()) * Vec3(-3e-5, 0, 4e-5);
            CHECK((contacts[0].spring.stretch - expected).norm() < 0.02 * expected.norm());
        }
}

TEST_CASE("solver of chapter 7: its pairs are as stiff as the depth that a scene wants asks for")
{
    const double dt = 0.004, of_mass = 100 * corner_mass / (dt * dt);
    Scene scene = scene_of({{10, Vec3(0, 0.5, 0)}}, dt);
    scene.contact.wanted_depth = corner_mass * 9.81 / (3 * of_mass);
    const Solver solver = chapter07_solver(scene.contact);
    CHECK(solver.finds_stiffness);
    Contacts contacts;
    for (int step = 0; step < 60; ++step)
        advance(scene.world, contacts, solver, dt);
    REQUIRE(contacts.size() == 4);
    for (const Contact& contact : contacts)
        CHECK(contact.spring.stiffness == doctest::Approx(3 * of_mass).epsilon(0.02));
}

TEST_CASE(
    "implicit contact: rounds and steps of Newton's method together keep to the bound, over all responses of a step")
{
    const double dt = 0.004;
    World world = cube_above_plane(1e-9, dt, 1, Vec3(3, -5, 1));
    Contacts contacts;
    for (const int vertex : lower_corners(*world.bodies[0]))
        contacts.push_back(corner_on_plane(vertex));
    SolveRecord last;
    ImplicitSettings settings;
    settings.friction = {0.9, 0.9};
    settings.tolerance = 0;  // never reached
    settings.max_newton_steps = 12;
    settings.record = [&](const SolveRecord& record) { last = record; };
    IslandMatrices matrices;
    solve_contacts(world, contacts, settings, matrices, dt);
    CHECK(last.rounds + last.newton_steps <= 12);
    CHECK(last.newton_steps > 2);
    const int first = last.newton_steps;
    for (int response = 0; response < 3; ++response) {  // each finds one more
        contacts.push_back(corner_on_plane(lower_corners(*world.bodies[0])[0]));
        solve_contacts(world, contacts, settings, matrices, dt);
        CHECK(first + last.newton_steps <= 12);
    }
}

TEST_CASE("solver of chapter 7: friction adds no pass, for the pairs' problem has it")
{
    const auto passes = [](const FrictionParameters& friction) {
        ContactParameters parameters;
        parameters.friction = friction;
        const Solver solver = chapter07_solver(parameters);
        std::vector<std::string> names;
        for (const StepStage stage :
             {StepStage::refresh, StepStage::detect, StepStage::respond, StepStage::finish})
            for (const Pass& pass : solver.passes(stage))
                names.push_back(pass.name);
        return names;
    };
    CHECK(passes(MassSplitting{.mu_s = 0.5, .mu_d = 0.4}) == passes(NoFriction{}));
}
