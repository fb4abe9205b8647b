#include "common/geometry/box_shapes.hpp"
#include "common/simulation/driven_body.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/step_attempt.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace enduring;

namespace {

World two_boxes()
{
    World world;
    for (const double mass : {2.0, 7.0}) {
        const SurfaceMesh mesh = box(Vec3::Ones());
        world.bodies.push_back(std::make_unique<RigidBody>(
            "box", mesh, with_mass(mass_properties(mesh, 1), mass), Vec3(1, -mass, 0.5)));
    }
    return world;
}

World turning_box(double speed)
{
    World world;
    world.gravity.setZero();
    const SurfaceMesh mesh = box(Vec3::Ones());
    world.bodies.push_back(std::make_unique<RigidBody>("top", mesh, with_mass(mass_properties(mesh, 1), 1),
                                                       Vec3::Zero(), speed * Vec3::UnitY()));
    return world;
}

/// Answers its one pair by turning the first body faster about y; this is on purpose.
Pass spin_up(double by)
{
    return {"spin up", [by](World& world, Contacts& contacts, double) {
                constexpr double inertia = 1.0 / 6, levers = 4;  // sum of the squares over eight corners
                Body& body = *world.bodies[0];
                const std::vector<Vec3> at(body.positions_t0().begin(), body.positions_t0().end());
                for (int v = 0; v < 8; ++v)
                    body.apply_impulse(
                        v, inertia / levers * by *
                               Vec3::UnitY().cross(at[static_cast<std::size_t>(v)] - body.centre()));
                world.attempt.added_energy += 1e9;
                for (Contact& contact : contacts)
                    contact.state = ContactState::answered;
            }};
}

/// How many parts a step is taken in.
int parts_of(World& world, const Pass& respond, double dt)
{
    int parts = 0;
    Solver solver;
    solver.max_halvings = 5;
    solver.append(StepStage::refresh, "count", [&](World&, Contacts& contacts, double) {
        contacts.assign(1, Contact{});
        ++parts;
    });
    solver.append(StepStage::respond, respond);
    solver.append(StepStage::finish, "forget", [](World&, Contacts& contacts, double) { contacts.clear(); });
    Contacts contacts;
    advance(world, contacts, solver, dt);
    return parts;
}

}  // namespace

TEST_CASE(
    "energy watch: what may be gained is a part of what moves, of what was put in, and of a fall from rest")
{
    for (const double dt : {0.002, 0.02}) {
        World world = two_boxes();
        const auto gains = [&](const HeldEnergy& before, double gain) {
            return has_gained(world, before, {before.total + gain, 0, 0}, dt);
        };
        CAPTURE(dt);
        const double fall = attempt_limits.gain_at_rest * 9 * 9.81 * 9.81 * dt * dt;
        CHECK_FALSE(gains({0, 0, 0}, 0.99 * fall));
        CHECK(gains({0, 0, 0}, 1.01 * fall));
        world.gravity.setZero();
        const double moving = attempt_limits.gain * 40, rounding = attempt_limits.rounding * 1e9;
        CHECK_FALSE(gains({0, 40, 0}, 0.99 * moving));
        CHECK(gains({0, 40, 0}, 1.01 * moving));
        CHECK_FALSE(gains({-1e9, 0, 0}, 0.99 * rounding));
        CHECK(gains({1e9, 0, 0}, 1.01 * rounding));
        world.attempt.added_energy = 40;
        CHECK_FALSE(gains({0, 0, 0}, 40 + 0.99 * moving));
        CHECK(gains({0, 0, 0}, 40 + 1.01 * moving));
        world.attempt.added_energy = -40;  // as a piston takes out that goes back
        CHECK_FALSE(gains({0, 0, 0}, -40 + 0.99 * moving));
        CHECK(gains({0, 0, 0}, -40 + 1.01 * moving));
        CHECK(gains({0, 0, 0}, std::numeric_limits<double>::quiet_NaN()));
    }
}

TEST_CASE("energy watch: without gravity a body may tremble, by a part of its size in a step")
{
    World world = two_boxes();
    world.gravity.setZero();
    double expected = 0;
    for (const auto& body : world.bodies)
        expected += body->mass() * std::pow(1e-8 * body->size() / 0.01, 2);
    const auto gains = [&](double gain) { return has_gained(world, {}, {gain, 0, 0}, 0.01); };
    CHECK_FALSE(gains(0.99 * expected));
    CHECK(gains(1.01 * expected));
}

TEST_CASE("energy watch: springs count among what moves")
{
    const World world = two_boxes();
    Contact pair;
    pair.spring.stiffness = 1000;
    pair.spring.load = 20;
    const HeldEnergy none = held_energy(world, {}), held = held_energy(world, {pair});
    CHECK(held.springs == doctest::Approx(0.2));
    CHECK(held.moving == doctest::Approx(none.moving + 0.2));
    CHECK(held.total == doctest::Approx(none.total + 0.2));
}

TEST_CASE("energy watch: work is that of the step's own length, by pairs that were answered")
{
    for (const double dt : {0.002, 0.02}) {
        World world = two_boxes();
        world.bodies.push_back(
            std::make_unique<DrivenBody>("table", box(Vec3(4, 0.1, 4)), Vec3(0.3, 0, 0),
                                         GivenMotion::steady(Vec3::Zero(), Vec3(0, 2, 0))));
        for (const auto& body : world.bodies)
            body->predict(Vec3::Zero(), dt);
        CAPTURE(dt);
        push_from_outside(world, 1, 3, Vec3(2, -1, 3));
        world.bodies[1]->update_prediction(dt);
        const Vec3 moved = world.bodies[1]->positions_t1()[3] - world.bodies[1]->positions_t0()[3];
        const double by_push = Vec3(2, -1, 3).dot(moved) / dt;
        CHECK(driven_work(world, {}, dt) == doctest::Approx(by_push));
        Contact pair{ContactKind::vertex_face, 0, 2, 0, 0, {0, 0, 1, 2}, {1, -0.25, -0.25, -0.5}};
        pair.friction = Vec3(3, 1, -2);
        CHECK(driven_work(world, {pair}, dt) == doctest::Approx(by_push));
        pair.state = ContactState::answered;
        Vec3 speed = Vec3::Zero();
        for (const std::size_t i : {1U, 2U, 3U}) {
            const auto v = static_cast<std::size_t>(pair.vertices[i]);
            speed -= pair.weights[i] *
                     (world.bodies[2]->positions_t1()[v] - world.bodies[2]->positions_t0()[v]) / dt;
        }
        const double by_table = by_push + pair.friction.dot(speed);
        CHECK(driven_work(world, {pair}, dt) == doctest::Approx(by_table));
        const Vec3 belt(0.5, -2, 4);
        world.bodies[2]->set_surface_velocity(belt);
        CHECK(driven_work(world, {pair}, dt) ==
              doctest::Approx(by_table));  // no solver reads it without springs
        pair.spring.stiffness = 1;
        CHECK(driven_work(world, {pair}, dt) == doctest::Approx(by_table + pair.friction.dot(belt)));
    }
}

TEST_CASE("step: a body that turns already may be turned further by as much as one that does not")
{
    const double dt = 0.004;
    for (const double turns : {0.0, 0.45}) {
        World less = turning_box(turns / dt), more = turning_box(turns / dt);
        CAPTURE(turns);
        CHECK(parts_of(less, spin_up(0.45 / dt), dt) == 1);
        CHECK(parts_of(more, spin_up(0.55 / dt), dt) > 1);
    }
}

TEST_CASE("step: one that leaves pairs unanswered is taken in halves, and told where no half is left")
{
    for (const int halvings : {0, 1, 3}) {
        CAPTURE(halvings);
        World world = two_boxes();
        const double first = world.time;
        Contacts contacts;
        Solver solver;
        solver.max_halvings = halvings;
        solver.append(StepStage::refresh, "forget", [](World&, Contacts& living, double) { living.clear(); });
        solver.append(StepStage::detect, "one more", [&](World& w, Contacts& found, double dt) {
            if (found.size() < 7 && dt > 0.003 &&
                w.time == first)  // a step of 10 ms has two halves that still do
                found.push_back({ContactKind::vertex_plane, 0, 0, 0, -1, {0, -1, -1, -1}, {1, 0, 0, 0}});
        });
        solver.append(StepStage::respond, "answer", [](World&, Contacts& found, double) {
            for (Contact& contact : found)
                contact.state = ContactState::answered;
        });
        advance(world, contacts, solver, 0.01);
        CHECK(world.time == doctest::Approx(first + 0.01));
        CHECK(world.thrown_away == std::min(halvings, 2));
        CHECK(world.ended_badly == (halvings == 1 ? 1 : 0));
    }
}

TEST_CASE("step: a solver without halves ends every step, and forgets how the last one went")
{
    const double dt = 0.004;
    World world = turning_box(0);
    world.attempt.added_energy = 7;
    Contacts contacts(1);
    Solver solver;
    solver.append(StepStage::respond, spin_up(3 / dt));
    advance(world, contacts, solver, dt);
    CHECK(world.time == doctest::Approx(dt));
    CHECK(world.bodies[0]->turning_speed() == doctest::Approx(3 / dt));
    CHECK(world.attempt.trouble == StepTrouble::turns_too_far);
    contacts.clear();
    advance(world, contacts, Solver(), dt);
    CHECK(world.attempt.added_energy == 0);
    CHECK(world.attempt.trouble == StepTrouble::none);
}

TEST_CASE(
    "step: numbers that are not finite stop a run where no half is left, and the first trouble is the one told")
{
    Solver solver;
    solver.max_halvings = 2;
    solver.append(StepStage::refresh, "poison", [](World& world, Contacts&, double dt) {
        world.bodies[0]->apply_impulse(0, Vec3(std::numeric_limits<double>::quiet_NaN(), 0, 0));
        world.bodies[0]->update_prediction(dt);
    });
    solver.append(StepStage::respond, "answer", [](World&, Contacts& contacts, double) {
        for (Contact& contact : contacts)
            contact.state = ContactState::answered;
    });
    World world = two_boxes();
    Contacts contacts(1);
    contacts[0] = {ContactKind::vertex_plane, 0, 0, 0, -1, {0, -1, -1, -1}, {1, 0, 0, 0}};
    CHECK_THROWS_AS(advance(world, contacts, solver, 0.01), std::runtime_error);
    CHECK(world.thrown_away == 2);

    Solver pushing;
    pushing.max_halvings = 1;
    pushing.append(StepStage::finish, "push", [](World& w, Contacts&, double) {
        w.bodies[0]->apply_impulse(0, 50 * w.bodies[0]->velocity(0).normalized());
        w.attempt.trouble = StepTrouble::unsolved;
    });
    World pushed = two_boxes();
    Contacts none;
    advance(pushed, none, pushing, 0.01);
    CHECK(pushed.ended_badly >= 2);
    CHECK(pushed.attempt.trouble == StepTrouble::unsolved);
}
