#include "chapters/07_implicit_contact/pair_memory.hpp"
#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/implicit_contact.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "chapters/07_implicit_contact/tests/only_island.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

using namespace enduring;
using namespace enduring::chapter07;

TEST_CASE("pair memory: a stiffness that changes changes no force, and its rest offset fades")
{
    const StiffnessChoice choice;
    Contact contact;
    adapt_stiffness(contact, 0.01, 2, choice, 0.01);
    CHECK(contact.spring.stiffness == doctest::Approx(100 * 2 / 1e-4));
    CHECK(contact.spring.rest_offset == 0);
    const double before = contact.spring.stiffness, depth = -1e-3, force = -before * depth;
    contact.spring.load = force;
    adapt_stiffness(contact, depth, 2, StiffnessChoice{.wanted_depth = 1e-5, .keep = 1}, 0.01);
    CHECK(contact.spring.stiffness > before);
    CHECK(-contact.spring.stiffness * (depth - contact.spring.rest_offset) == doctest::Approx(force));
    const double rest_offset = contact.spring.rest_offset;
    for (int i = 0; i < 50; ++i)
        adapt_stiffness(contact, 1e-6, 2, choice, 0.01);
    CHECK(std::abs(contact.spring.rest_offset) < 0.01 * std::abs(rest_offset));
}

TEST_CASE("pair memory: a mass and a load each ask for a stiffness, and the larger one counts")
{
    const StiffnessChoice choice{.k_dt2_over_m = 25, .wanted_depth = 1e-3};
    CHECK(wanted_stiffness(3, 10, choice, 0.02) == doctest::Approx(25 * 3 / (0.02 * 0.02)));
    CHECK(wanted_stiffness(3, 1e6, choice, 0.02) == doctest::Approx(1e9));
}

TEST_CASE("pair memory: a load asks in vain for more than ten million times the mass")
{
    for (const double dt : {0.01, 0.002})
        CHECK(wanted_stiffness(1e-3, 1e12, {}, dt) == doctest::Approx(1e7 * 1e-3 / (dt * dt)));
}

TEST_CASE("pair memory: a rest offset fades no faster than at a part of the natural speed, so it is no motor")
{
    Contact deep;
    adapt_stiffness(deep, -0.2, 1, {}, 0.01);
    REQUIRE(deep.spring.rest_offset == -0.2);
    adapt_stiffness(deep, -0.2, 1, {}, 0.01);
    CHECK(deep.spring.rest_offset == doctest::Approx(-0.2 + 0.3443 * 0.01).epsilon(1e-4));
    double before = deep.spring.rest_offset;
    adapt_stiffness(deep, before, 1, {}, 0.002);  // at rest where its spring is slack
    CHECK(deep.spring.rest_offset == doctest::Approx(before + 0.3443 * 0.002).epsilon(1e-4));
    before = deep.spring.rest_offset;
    const NaturalUnits of_a_hundredth{0.01, 0.313};
    adapt_stiffness(deep, before, 1, StiffnessChoice{}.of_pair(of_a_hundredth), 0.01);
    CHECK(deep.spring.rest_offset == doctest::Approx(before + 0.03443 * 0.01).epsilon(1e-4));
}

TEST_CASE(
    "pair memory: a stiffness rises with its load, and falls where it is twice what mass and load ask for")
{
    for (const double dt : {0.01, 0.002}) {
        const StiffnessChoice choice{.wanted_depth = 1e-5};
        const double own = 100 * 2 / (dt * dt);
        Contact contact;
        adapt_stiffness(contact, 0, 2, choice, dt);
        for (const auto& [load, stiffness] :
             {std::pair(3.0, 3.0), {50.0, 50.0}, {26.0, 50.0}, {24.0, 24.0}, {0.2, 1.0}, {0.0, 1.0}}) {
            contact.spring.load = load * own * 1e-5;
            const double depth = contact.spring.rest_offset - contact.spring.load / contact.spring.stiffness;
            adapt_stiffness(contact, depth, 2, choice, dt);
            CHECK(contact.spring.stiffness == doctest::Approx(stiffness * own));
        }
    }
}

TEST_CASE("pair memory: a spring that is wound up above its load stays as stiff as it is, or it would throw")
{
    for (const double wound_up : {1e-8, 2e-3}) {
        const StiffnessChoice choice{.wanted_depth = 1e-5};
        Contact contact;
        adapt_stiffness(contact, 0, 2, choice, 0.01);
        contact.spring.stiffness = 1e9;
        contact.spring.load = 20;
        contact.spring.rest_offset = -0.4 + wound_up;
        adapt_stiffness(contact, -0.4, 2, choice, 0.01);
        CHECK((contact.spring.stiffness == 1e9) == (wound_up > 1e-3));
    }
}

TEST_CASE("pair memory: loads that come and go bring no energy to a spring whose stiffness follows them")
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> decades(-3, 3);
    const double wanted_depth = 1e-5, dt = 0.01;
    const StiffnessChoice choice{.wanted_depth = wanted_depth, .keep = 1};  // no offset fades
    Contact contact;
    adapt_stiffness(contact, 0, 2, choice, dt);
    const double first = contact.spring.stiffness;
    double brought = 0;
    for (int i = 0; i < 100; ++i) {
        contact.spring.load = first * wanted_depth * std::pow(10, decades(random));
        const double depth = contact.spring.rest_offset - contact.spring.load / contact.spring.stiffness;
        const double before = contact.spring.load * contact.spring.load / (2 * contact.spring.stiffness);
        adapt_stiffness(contact, depth, 2, choice, dt);
        const double compressed = depth - contact.spring.rest_offset;
        brought += contact.spring.stiffness / 2 * compressed * compressed - before;
        CAPTURE(i);
        CHECK(brought <= wanted_depth * wanted_depth / 2 * (first - contact.spring.stiffness) * (1 - 1e-9));
    }
    CHECK(brought < 0);
}

TEST_CASE(
    "pair memory: a spring that is not compressed stays uncompressed at its depth when it becomes stiffer")
{
    Contact contact;
    adapt_stiffness(contact, 1e-3, 2, {}, 0.01);
    const double before = contact.spring.stiffness;
    contact.spring.load = 1e9;
    contact.spring.stretch = Vec3(1e-5, 0, 0);
    adapt_stiffness(contact, 1e-3, 2, {}, 0.01);
    CHECK(contact.spring.stiffness > 1.9 * before);
    CHECK(contact.spring.rest_offset == 0);
    CHECK(contact.spring.stretch == Vec3(1e-5, 0, 0));
}

TEST_CASE("pair memory: where the stiffness rises, friction holds what it held before")
{
    Contact contact;
    adapt_stiffness(contact, 0, 2, {}, 0.01);
    contact.spring.load = 1e9;
    contact.spring.stretch = Vec3(1e-5, 0, -2e-5);
    const Vec3 force = contact.spring.stiffness * contact.spring.stretch;
    adapt_stiffness(contact, -1e-4, 2, {}, 0.01);
    CHECK((contact.spring.stiffness * contact.spring.stretch - force).norm() <= 1e-12 * force.norm());
}

TEST_CASE(
    "pair memory: a pair that cannot move out is wound up once above the most load, and keeps what it carries")
{
    for (const bool seen : {true, false})  // where pushes cancel, only its spring tells what it carries
        for (const double carried : {20.0, 1e4}) {
            Contact contact;
            const double depth = -0.02, max_load = 5e3;
            adapt_stiffness(contact, 0, 1, {}, 0.01, max_load);
            contact.spring.rest_offset = depth + carried / contact.spring.stiffness;
            double force = carried;
            for (int step = 0; step < 200; ++step) {
                contact.spring.load = seen ? force : 0;
                adapt_stiffness(contact, depth, 1, {}, 0.01, max_load);
                force = contact.spring.stiffness * (contact.spring.rest_offset - depth);
            }
            const double once = contact.spring.stiffness * StiffnessChoice{}.fading_speed() * 0.01;
            CHECK(force >= doctest::Approx(std::max(carried, max_load)).epsilon(1e-9));
            CHECK(force <= std::max(carried, max_load + once + contact.spring.stiffness * 1e-5));
        }
}

TEST_CASE("pair memory: a rest offset fades under the most load, and not under more")
{
    for (const double part : {0.0, 0.5, 0.99, 1.01, 5.0}) {
        Contact pressed;
        pressed.spring.stiffness = 1e6;
        pressed.spring.rest_offset = -0.01;
        pressed.spring.load = part * 2e3;
        adapt_stiffness(pressed, -0.01, 1, {}, 0.01, 2e3);
        CAPTURE(part);
        CHECK((pressed.spring.rest_offset > -0.01) == (part < 1));
    }
}

TEST_CASE("pair memory: a pair that is held lets its spring go, and begins anew where it pushes again")
{
    const Scene scene = scene_of(stack_of(1), 0.01);
    Contact pair{ContactKind::vertex_plane, 0, 0, 0, 0, {0}, {1}};
    pair.spring.stiffness = 1e5;
    pair.spring.load = 40;
    pair.spring.rest_offset = -1e-3;
    pair.impulse = Vec3(0, 0.2, 0);
    pair.friction = Vec3(0.1, 0, 0);
    pair.spring.stretch = Vec3(1e-4, 0, 0);
    Contacts contacts{pair, pair};
    contacts[0].hold(true);
    remember_pairs(scene.world, contacts, 0.01);
    CHECK(contacts[0].spring.stiffness == 0);
    CHECK(contacts[0].spring.stretch.isZero(0));
    CHECK(contacts[0].spring.load == 40);
    CHECK(contacts[1].spring.stiffness == 1e5);
    CHECK(contacts[1].spring.stretch.isApprox(Vec3(-1e-4, 0, 0)));
    CHECK(contacts[1].spring.load == doctest::Approx(20));
    adapt_stiffness(contacts[0], -0.02, 1, {}, 0.01);
    CHECK(contacts[0].spring.rest_offset == -0.02);
}

TEST_CASE(
    "pair memory: the springs of a step that is not solved hold what their pairs gave, whether it could be halved or not")
{
    for (const int unsolved : {0, 1})
        for (const bool may_be_halved : {true, false})
            for (const double impulse : {0.0, 0.2}) {
                Scene scene = scene_of(stack_of(1), 0.01);  // its lower corners are where the plane is
                scene.world.attempt.may_be_halved = may_be_halved;
                scene.world.attempt.work.unsolved = unsolved;
                Contact pair{ContactKind::vertex_plane, 0, 0, 0, 0, {0}, {1}};
                pair.spring.stiffness = 1e5;
                pair.impulse = Vec3(0, impulse, 0);
                const double depth = contact_geometry(scene.world, pair, 1).depth,
                             pressed = impulse / 0.01 / pair.spring.stiffness;
                pair.spring.rest_offset = depth + 5e-3;  // of the law that was not solved: 500 N
                Contacts contacts{pair, pair};
                contacts[1].spring.rest_offset = depth - 1e-3;  // slack, and stays so
                remember_pairs(scene.world, contacts, 0.01);
                CHECK(contacts[0].spring.rest_offset ==
                      doctest::Approx(depth + (unsolved > 0 ? pressed : 5e-3)).epsilon(1e-12));
                CHECK(contacts[1].spring.rest_offset == depth - 1e-3);
            }
}

TEST_CASE("pair memory: a rest offset deeper than the load has pressed does not rub, any other pair does")
{
    Scene scene = scene_of(stack_of(1), 0.01);
    scene.world.bodies[0]->predict(scene.world.gravity, scene.dt);
    // a corner feels a quarter of the cube's 10 kg, which begins with so many N/m
    const double first = 100 * 2.5 / (0.01 * 0.01), wanted_depth = 1e-5;
    StiffnessChoice choice;
    choice.wanted_depth = wanted_depth;
    struct Spring {
        double rest_offset, pressed;  // [m]
        bool rubs;
    };
    for (const Spring& spring : {Spring{-0.02, 1e-5, false}, Spring{-0.02, 0.0199, false},
                                 Spring{-0.02, 0.0201, true}, Spring{-0.99e-3, 0, true}}) {
        CAPTURE(spring.pressed);
        Contact pair{ContactKind::vertex_plane, 0, 0, 0, -1, {0, -1, -1, -1}, {1, 0, 0, 0}};
        pair.spring.stiffness = 1e8;
        pair.spring.rest_offset = spring.rest_offset;
        pair.spring.load = first * spring.pressed;
        Contacts contacts{pair};
        const StepProblem step = set_up_only_island(scene.world, contacts, choice, {0.5, 0.4}, {1, scene.dt},
                                                    false);
        REQUIRE(step.problem.rows.size() == 1);
        CHECK(step.problem.rows[0].law.mu == (spring.rubs ? 0.5 : 0));
    }
}

TEST_CASE("pair memory: a pair that is born inside pushes nobody, one from outside at its full depth")
{
    Contact inside, outside;
    adapt_stiffness(inside, -0.02, 1, {}, 0.01);
    adapt_stiffness(outside, 0.003, 1, {}, 0.01);
    CHECK(inside.spring.rest_offset == -0.02);
    CHECK(outside.spring.rest_offset == 0);
}

TEST_CASE(
    "pair memory: a new pair's stiffness comes from the mass that it feels, both bodies' and with their turn")
{
    for (const auto& [below, above] : {std::pair(1.0, 1000.0), std::pair(1000.0, 1.0), std::pair(3.0, 5.0)}) {
        Scene scene = scene_of({{below, Vec3(0, 0.5, 0)}, {above, Vec3(0.1, 1.5, 0.2)}}, 0.01);
        ImplicitSettings settings;
        settings.max_newton_steps = 0;      // or else what presses through the light one would count as well
        settings.kept_residual = INFINITY;  // and the step is a whole one
        settings.record = [](const SolveRecord&) {};
        const Solver solver = chapter07_solver(scene.contact, settings);
        for (int corner = 0; corner < 8; ++corner)  // else they fall side by side, and never meet
            scene.world.bodies[1]->apply_impulse(corner, Vec3(0, -0.1 * above / 8, 0));
        Contacts contacts;
        // A push at a cube's corner moves it there by 4/m: by 1/m as a whole, and by 3/m as it turns. One
        // where the other cube's corner lies moves it by 2.5/m.
        const auto stiffnesses_are = [&](ContactKind kind, int body, double response) {
            int pairs = 0;
            for (const Contact& contact : contacts)
                if (contact.kind == kind && contact.body_a == body) {
                    ++pairs;
                    CHECK(contact.spring.stiffness == doctest::Approx(100 / (response * 1e-4)).epsilon(1e-3));
                }
            return pairs;
        };
        advance(scene.world, contacts, solver, scene.dt);
        CHECK(stiffnesses_are(ContactKind::vertex_plane, 0, 4 / below) == 4);
        CHECK(stiffnesses_are(ContactKind::vertex_face, 1, 4 / above + 2.5 / below) > 0);
        CHECK(stiffnesses_are(ContactKind::vertex_face, 0, 4 / below + 2.5 / above) > 0);
    }
}
