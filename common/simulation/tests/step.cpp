#include "common/simulation/step.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/tests/triangle_body.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace enduring;

namespace {

World one_triangle(const Vec3& gravity = Vec3::Zero())
{
    World world;
    world.gravity = gravity;
    world.bodies.push_back(triangle("sheet"));
    return world;
}

/// Writes its name into a log each time it runs; then does what it is told.
Pass logged(const std::string& name, std::string& log, std::function<void(World&, Contacts&)> work = {})
{
    return {name, [&log, name, work](World& world, Contacts& contacts, double) {
                log += name + " ";
                if (work)
                    work(world, contacts);
            }};
}

void append_contact(World&, Contacts& contacts)
{
    Contact found;
    found.start = 0.5;
    contacts.push_back(found);
}

void handle_all(World&, Contacts& contacts)
{
    for (Contact& contact : contacts)
        contact.state = ContactState::answered;
}

}  // namespace

TEST_CASE("step: a body without contact follows symplectic Euler")
{
    World world = one_triangle({0, -10, 0});
    Contacts contacts;
    for (int i = 0; i < 5; ++i)
        advance(world, contacts, {}, 0.1);
    // v_n = -n, so that y_n = -0.1 (1 + 2 + 3 + 4 + 5).
    CHECK(world.bodies[0]->positions_t0()[1].y() == doctest::Approx(-1.5));
    CHECK(world.bodies[0]->velocity(1).y() == doctest::Approx(-5));
    CHECK(world.time == doctest::Approx(0.5));
    CHECK(world.step == 5);
}

TEST_CASE("step: without contacts one detection ends it, and nothing responds")
{
    std::string log;
    World world = one_triangle();
    Contacts contacts;
    advance(world, contacts,
            {"", {logged("enduring", log)}, {logged("detect", log)}, {logged("respond", log)}}, 0.1);
    CHECK(log == "enduring detect ");
}

TEST_CASE("step: detection and response alternate until nothing new appears")
{
    std::string log;
    int finds = 2;
    const Pass detect = logged("d", log, [&](World& world, Contacts& contacts) {
        if (finds-- > 0)
            append_contact(world, contacts);
    });
    World world = one_triangle();
    Contacts contacts;
    advance(world, contacts, {"", {}, {detect}, {logged("r", log, handle_all)}}, 0.1);
    CHECK(log == "d r d r d ");
    CHECK(contacts.size() == 2);
}

TEST_CASE("step: five responses are the most, and what the last detection finds waits unhandled")
{
    std::string log;
    World world = one_triangle();
    Contacts contacts;
    advance(world, contacts, {"", {}, {logged("d", log, append_contact)}, {logged("r", log, handle_all)}},
            0.1);
    CHECK(log == "d r d r d r d r d r d ");
    REQUIRE(contacts.size() == 6);
    CHECK(contacts[4].answered());
    CHECK_FALSE(contacts[5].answered());
}

TEST_CASE("step: a contact that lives on starts the new step waiting, without impulse, and from tau = 0")
{
    World world = one_triangle();
    Contacts contacts(1);
    contacts[0].start = 0.7;
    contacts[0].state = ContactState::answered;
    contacts[0].impulse = {1, 2, 3};
    contacts[0].friction = {3, 2, 1};
    bool seen = false;
    const Pass enduring{"enduring", [&](World&, Contacts& living, double) {
                            seen = living.size() == 1 && living[0].start == 0 && !living[0].answered() &&
                                   living[0].impulse.isZero() && living[0].friction.isZero();
                        }};
    std::string log;
    advance(world, contacts, {"", {enduring}, {}, {logged("r", log, handle_all)}}, 0.1);
    CHECK(seen);
    CHECK(log == "r ");
}

TEST_CASE(
    "step: a pair's vertices receive its impulse and its friction by their weights, once, and only while it waits")
{
    World world = one_triangle();
    world.bodies.push_back(triangle("second sheet"));
    Contact contact{ContactKind::vertex_face, 0, 1, 2, 0, {2, 0, 1, 2}, {1, -0.5, -0.3, -0.2}};
    contact.impulse = {0, 4, 0};
    contact.friction = {1, 0, 0};
    Contacts contacts(3, contact);
    contacts[1].hold(true);
    contacts[2].resolved = true;
    for (int round = 0; round < 2; ++round) {
        apply_impulses(world, contacts);
        CHECK((world.bodies[0]->velocity(2) - Vec3(1, 4, 0)).norm() < 1e-15);
        CHECK((world.bodies[1]->velocity(0) - Vec3(-0.5, -2, 0)).norm() < 1e-15);
        CHECK((world.bodies[1]->velocity(1) - Vec3(-0.3, -1.2, 0)).norm() < 1e-15);
        CHECK((world.bodies[1]->velocity(2) - Vec3(-0.2, -0.8, 0)).norm() < 1e-15);
        CHECK(world.bodies[0]->velocity(0).isZero());
        CHECK(contacts[0].answered());
        CHECK_FALSE(contacts[1].answered());
    }
}

TEST_CASE("step: impulses of one pass do not see each other, and their order does not matter")
{
    const Vec3 first{0, 1, 0}, second{0.5, 0, -2};
    std::vector<Vec3> ends;
    for (const bool swapped : {false, true}) {
        World world = one_triangle();
        bool prediction_stayed = true;
        const Pass respond{"r", [&](World& in, Contacts& contacts, double) {
                               Body& body = *in.bodies[0];
                               const Vec3 before = body.positions_t1()[0];
                               body.apply_impulse(0, swapped ? second : first);
                               prediction_stayed = prediction_stayed && body.positions_t1()[0] == before;
                               body.apply_impulse(0, swapped ? first : second);
                               handle_all(in, contacts);
                           }};
        Contacts contacts(1);
        advance(world, contacts, {"", {}, {}, {respond}}, 0.5);
        CHECK(prediction_stayed);
        ends.push_back(world.bodies[0]->positions_t0()[0]);
    }
    CHECK(ends[0] == ends[1]);
    CHECK((ends[0] - Vec3(0.25, 0.5, -1)).norm() < 1e-15);  // 1 kg: dt (I1 + I2)
}

TEST_CASE("step: a NaN stops the run and names step, body and vertex")
{
    World world = one_triangle();
    world.bodies.push_back(triangle("second sheet"));
    Contacts contacts(1);
    const Pass poison{
        "r", [&](World& in, Contacts& all, double) {
            if (in.step == 2)
                in.bodies[1]->apply_impulse(1, {0, std::numeric_limits<double>::quiet_NaN(), 0});
            handle_all(in, all);
        }};
    const Solver solver{"", {}, {}, {poison}};
    advance(world, contacts, solver, 0.1);
    advance(world, contacts, solver, 0.1);
    CHECK_THROWS_WITH_AS(
        advance(world, contacts, solver, 0.1),
        "step 3: body 'second sheet', vertex 1: the position predicted after contact impulses is not a finite number",
        std::runtime_error);
}

TEST_CASE("step: an infinite velocity is caught in the prediction")
{
    World world = one_triangle({0, -std::numeric_limits<double>::infinity(), 0});
    Contacts contacts;
    CHECK_THROWS_WITH_AS(advance(world, contacts, {}, 0.1), doctest::Contains("body 'sheet', vertex 0"),
                         std::runtime_error);
}

TEST_CASE("step: the observer hears of every pass by its name, in order")
{
    std::string log, heard;
    World world = one_triangle();
    Contacts contacts(1);
    advance(world, contacts,
            {"", {logged("e", log)}, {logged("d", log)}, {logged("r", log, handle_all)}, {logged("f", log)}},
            0.1, [&](const std::string& pass) { heard += pass + ","; });
    CHECK(heard == "predict,e,d,r,apply impulses,update prediction,d,f,commit,");
}

namespace {

World spinning_cube(double speed)
{
    World world;
    world.gravity.setZero();
    MassProperties properties;
    properties.mass = 1;
    properties.inertia = Mat3::Identity();
    const SurfaceMesh mesh = box(Vec3::Ones());
    world.bodies.push_back(
        std::make_unique<RigidBody>("top", mesh, properties, Vec3::Zero(), speed * Vec3::UnitY()));
    return world;
}

}  // namespace

TEST_CASE("step: one in which a body turns too far is taken in halves, and is still one step")
{
    for (const auto& [turns, parts] :
         {std::pair(0.2, 1), std::pair(0.49, 1), std::pair(0.51, 2), std::pair(4.9, 16)}) {
        const double turn = turns;
        std::string log;
        World world = spinning_cube(turn / 0.01);
        Solver solver{"", {}, {logged("d", log)}, {}};
        solver.max_halvings = 5;
        Contacts contacts;
        advance(world, contacts, solver, 0.01);
        CAPTURE(turn);
        CHECK(log.size() == static_cast<std::size_t>(2 * parts));
        CHECK(world.step == 1);
        CHECK(world.time == doctest::Approx(0.01).epsilon(1e-12));
        const Vec3 corner = world.bodies[0]->positions_t0()[0],
                   first = spinning_cube(0).bodies[0]->positions_t0()[0];
        CHECK((corner - Eigen::AngleAxisd(turn, Vec3::UnitY()) * first).norm() < 1e-9);
    }
}

TEST_CASE("step: the fastest of all bodies tells how short the halves are, wherever it stands among them")
{
    for (const bool first : {true, false}) {
        std::string log;
        World world = spinning_cube(first ? 490 : 1), other = spinning_cube(first ? 1 : 490);
        world.bodies.push_back(std::move(other.bodies[0]));
        Solver solver{"", {}, {logged("d", log)}, {}};
        solver.max_halvings = 5;
        Contacts contacts;
        advance(world, contacts, solver, 0.01);
        CHECK(log.size() == 32);  // sixteen parts
    }
}

TEST_CASE("step: what a step begins turns no further in what is left of it")
{
    std::string log;
    World world = spinning_cube(0.8 / 0.01);
    Solver solver{"", {}, {}, {}, {logged("spin up", log, [](World& w, Contacts&) {
                      w.bodies[0]->apply_impulse(0, Vec3(0, 0, 100));
                  })}};
    solver.max_halvings = 5;
    Contacts contacts;
    advance(world, contacts, solver, 0.01);
    CHECK(log.size() > 2 * std::string("spin up ").size());  // more than the two parts that it began with
    CHECK(world.time == doctest::Approx(0.01).epsilon(1e-12));
}

TEST_CASE("step: who turns a thousand times too far is named")
{
    World world = spinning_cube(513 / 0.01);
    Solver solver;
    solver.max_halvings = 5;
    Contacts contacts;
    CHECK_THROWS_WITH_AS(advance(world, contacts, solver, 0.01),
                         "step 1: body 'top' turns by 513 rad in a step; make dt shorter",
                         std::runtime_error);
}
