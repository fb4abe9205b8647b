#include "common/simulation/step_attempt.hpp"

#include "common/geometry/box_shapes.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/driven_body.hpp"
#include "common/simulation/rigid_body.hpp"

#include <doctest/doctest.h>

using namespace enduring;

namespace {

/// Two bodies of different mass that move and turn.
World two_boxes()
{
    World world;
    for (const double mass : {2.0, 7.0}) {
        const SurfaceMesh mesh = box(Vec3(1, 0.5, 0.25) * mass);
        world.bodies.push_back(std::make_unique<RigidBody>(
            "box", mesh, with_mass(mass_properties(mesh, 1), mass), Vec3(1, -mass, 0.5), Vec3(3, mass, -1)));
    }
    return world;
}

/// Pushes the first body along its motion in each step, as a wrong answer would.
Solver pushing(double impulse)
{
    Solver solver;
    solver.max_halvings = 5;
    solver.append(StepStage::finish, "push", [impulse](World& world, Contacts&, double) {
        world.bodies[0]->apply_impulse(0, impulse * world.bodies[0]->velocity(0).normalized());
    });
    return solver;
}

std::vector<double> numbers_of(World& world)
{
    StateArchive all;
    for (const auto& body : world.bodies)
        body->visit_state(all);
    return all.numbers();
}

}  // namespace

TEST_CASE(
    "step attempt: a step that gains energy is taken in halves, and one whose springs were wound up on purpose is not")
{
    for (const double dt : {0.002, 0.02}) {
        CAPTURE(dt);
        Contacts contacts;
        World world = two_boxes();
        advance(world, contacts, pushing(0), dt);
        CHECK(world.thrown_away == 0);
        CHECK(world.time == doctest::Approx(dt));

        World pushed = two_boxes();
        advance(pushed, contacts, pushing(5), dt);
        CHECK(pushed.thrown_away >= 31);  // each part of 1/32 is pushed again, so none ends well
        CHECK(pushed.ended_badly >= 32);
        CHECK(pushed.work.attempts == pushed.thrown_away + pushed.work.parts);
        CHECK(pushed.work.ended_badly == pushed.ended_badly);
        CHECK(pushed.time == doctest::Approx(dt));
        CHECK(pushed.step == 1);

        World on_purpose = two_boxes();
        Solver solver = pushing(5);
        solver.append(StepStage::finish, "book",
                      [](World& w, Contacts&, double) { w.attempt.added_energy += 1e4; });
        advance(on_purpose, contacts, solver, dt);
        CHECK(on_purpose.thrown_away == 0);
    }
}

TEST_CASE("step attempt: what is brought back is the state of before, to the last bit")
{
    World world = two_boxes();
    const SurfaceMesh table = box(Vec3(4, 0.1, 4));
    world.bodies.push_back(std::make_unique<DrivenBody>("table", table, Vec3::Zero(),
                                                        GivenMotion::steady(Vec3::Zero(), Vec3(0, 2, 0))));
    DeformableSettings soft;
    soft.material = {1e5, 0.3, 1000};
    soft.impulse_response = ImpulseResponse::implicit;
    soft.angular_velocity = Vec3(1, 2, 3);
    world.bodies.push_back(std::make_unique<DeformableBody>("soft", bar(Vec3::Ones(), {2, 1, 1}), soft));
    Contacts contacts;
    const Solver solver{"", {}, {}, {}};
    for (int i = 0; i < 3; ++i)
        advance(world, contacts, solver, 0.01);

    contacts.resize(3);
    contacts[1].spring.load = 7;
    const SavedState saved(world, contacts);
    contacts.clear();
    const std::vector<double> before = numbers_of(world);
    const auto go_on = [&] {
        for (const double dt : {0.02, 0.004})
            advance(world, contacts, solver, dt);
        return numbers_of(world);
    };
    const std::vector<double> first = go_on();
    saved.restore(world, contacts);
    CHECK(numbers_of(world) == before);
    CHECK(world.time == doctest::Approx(0.03));
    REQUIRE(contacts.size() == 3);
    CHECK(contacts[1].spring.load == 7);
    contacts.clear();
    const std::vector<double> again = go_on();
    REQUIRE(again.size() == first.size());
    for (std::size_t i = 0; i < first.size(); ++i)
        CHECK(again[i] ==
              doctest::Approx(first[i]).epsilon(1e-8));  // the linear solver's factor may be another
    CHECK(first != before);
}

TEST_CASE("step attempt: a body that moves as given books its work, and what rubs against it gains that much")
{
    World world = two_boxes();
    const SurfaceMesh table = box(Vec3(4, 0.1, 4));
    world.bodies.push_back(std::make_unique<DrivenBody>("table", table, Vec3::Zero(),
                                                        GivenMotion::steady(Vec3::Zero(), Vec3(0, 2, 0))));
    for (const auto& body : world.bodies)
        body->predict(Vec3::Zero(), 0.01);
    Contact contact{ContactKind::vertex_face, 0, 2, 0, 0, {0, 0, 1, 2}, {1, -0.25, -0.25, -0.5}};
    contact.friction = Vec3(3, 1, -2);
    contact.state = ContactState::answered;
    Vec3 moved = Vec3::Zero();
    for (int i = 1; i < 4; ++i)
        moved -= contact.weights[i] * (world.bodies[2]->positions_t1()[contact.vertices[i]] -
                                       world.bodies[2]->positions_t0()[contact.vertices[i]]);
    CHECK(moved.norm() > 0.01);
    CHECK(driven_work(world, {contact}, 0.01) == doctest::Approx(contact.friction.dot(moved) / 0.01));
}

TEST_CASE("step attempt: a push from outside may put energy in, as much as its work, step after step")
{
    for (const bool told : {true, false}) {
        CAPTURE(told);
        World world = two_boxes();
        Solver solver;
        solver.max_halvings = 5;
        solver.append(StepStage::refresh, "push", [told](World& w, Contacts&, double dt) {
            const Vec3 impulse(900 * dt, -200 * dt, 0);  // a force of 900 N
            if (told)
                push_from_outside(w, 1, 3, impulse);
            else
                w.bodies[1]->apply_impulse(3, impulse);
            w.bodies[1]->update_prediction(dt);
        });
        Contacts contacts;
        for (int step = 0; step < 3; ++step) {
            advance(world, contacts, solver, 0.01);
            CHECK(world.attempt.from_outside.size() == (told ? 1 : 0));
        }
        CHECK((world.thrown_away == 0) == told);
    }
}
