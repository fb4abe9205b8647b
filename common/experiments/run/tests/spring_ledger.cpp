#include "common/experiments/run/spring_ledger.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/tests/triangle_body.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <utility>

using namespace enduring;

namespace {

/// Three points of 1 kg, so deep in the ground, weightless.
World points_in_ground(double depth, const Vec3& velocity = {0, 0, 0})
{
    World world;
    world.gravity.setZero();
    world.planes.push_back({"ground", Vec3::Zero(), Vec3::UnitY()});
    world.bodies.push_back(triangle("points", -depth, velocity));
    return world;
}

/// A pair that pushed in the step just done.
Contact on_ground(int vertex, double rest_offset = 0)
{
    Contact contact{ContactKind::vertex_plane, 0, 0, vertex, -1, {vertex, -1, -1, -1}, {1, 0, 0, 0}};
    contact.spring.rest_offset = rest_offset;
    contact.spring.stiffness = 2000;
    contact.state = ContactState::answered;
    return contact;
}

constexpr double dt = 0.01, max_depenetration_velocity = 0.5;

}  // namespace

TEST_CASE(
    "spring ledger: a pair that comes at a depth is born with its energy, and one that ends there takes it along")
{
    const World world = points_in_ground(0.1);
    SpringLedger ledger(world, 1000, max_depenetration_velocity);
    ledger.add_step(world, {on_ground(0), on_ground(1, -0.04)}, dt);
    CHECK(ledger.accounts().born == doctest::Approx(0.5 * 2000 * (0.01 + 0.0036)));
    CHECK(ledger.held() == doctest::Approx(ledger.accounts().born));
    ledger.add_step(world, {on_ground(1, -0.04)}, dt);
    CHECK(ledger.accounts().died == doctest::Approx(0.5 * 2000 * 0.01));
    Contact held = on_ground(1, -0.04);
    held.hold(true);
    ledger.add_step(world, {held}, dt);
    CHECK(ledger.accounts().died == doctest::Approx(ledger.accounts().born));
    CHECK(ledger.held() == 0);
}

TEST_CASE("spring ledger: in a step that ended badly a spring holds no more than its pair pushed with")
{
    World world = points_in_ground(0.1);
    Contact jammed = on_ground(0);
    jammed.spring.load = 20;  // a tenth of what its depth says
    SpringLedger ledger(world, 1000, max_depenetration_velocity);
    ++world.ended_badly;
    ledger.add_step(world, {jammed}, dt);
    CHECK(ledger.held() == doctest::Approx(0.01 * 0.5 * 2000 * 0.01));
    ledger.add_step(world, {jammed}, dt);  // which ends well: what is said is what the depth says
    CHECK(ledger.held() == doctest::Approx(0.5 * 2000 * 0.01));
}

TEST_CASE(
    "spring ledger: a rest offset that fades at the largest depenetration velocity lifts, and a faster one makes a jump")
{
    const World world = points_in_ground(0.1);
    for (const double speed : {0.3, 0.5, 0.51, 4.0}) {
        CAPTURE(speed);
        SpringLedger ledger(world, 1000, max_depenetration_velocity);
        ledger.add_step(world, {on_ground(0, -0.1)}, dt);
        Contact lifting = on_ground(0, -0.1 + speed * dt);
        lifting.impulse = {0, 30 * dt, 0};
        ledger.add_step(world, {lifting}, dt);
        const double way = speed * dt, added_energy = 0.5 * 2000 * way * way;
        const SpringAccounts& sums = ledger.accounts();
        CHECK(sums.lifted == doctest::Approx(speed <= max_depenetration_velocity ? 30 * way : 0));
        CHECK(sums.jumped == doctest::Approx(speed <= max_depenetration_velocity ? 0 : added_energy));
        CHECK(sums.born == 0);
    }
}

TEST_CASE(
    "spring ledger: a spring that gets stiffer and pushes as before puts nothing in, and what it loses is damped")
{
    const World world = points_in_ground(0.1);
    for (const double factor : {1.0, 2.0, 50.0, 1e4}) {
        CAPTURE(factor);
        SpringLedger ledger(world, 1000, max_depenetration_velocity);
        ledger.add_step(world, {on_ground(0)}, dt);
        const double force = 2000 * 0.1, before = 0.5 * force * 0.1;
        Contact stiffer = on_ground(0, -0.1 + 0.1 / factor);
        stiffer.spring.stiffness *= factor;
        stiffer.impulse = {0, force * dt, 0};
        ledger.add_step(world, {stiffer}, dt);
        const SpringAccounts& sums = ledger.accounts();
        CHECK(std::abs(sums.lifted) < 1e-12 * before);
        CHECK(sums.jumped == 0);
        CHECK(ledger.held() == doctest::Approx(before / factor));
        CHECK(sums.damped == doctest::Approx(before - before / factor));
    }
}

TEST_CASE(
    "spring ledger: what waits has not begun, and a pair without a stiffness of its own has that of all")
{
    const World world = points_in_ground(0.1);
    Contact waiting = on_ground(0), plain = on_ground(1);
    waiting.state = ContactState::waiting;
    plain.spring.stiffness = 0;
    SpringLedger ledger(world, 1000, max_depenetration_velocity);
    ledger.add_step(world, {waiting, plain}, dt);
    CHECK(ledger.held() == doctest::Approx(0.5 * 1000 * 0.01));
}

TEST_CASE("spring ledger: another face of the same vertex is a jump, by the difference of depths")
{
    World world;
    world.bodies.push_back(triangle("points", -0.1));
    world.bodies.push_back(triangle("sheet"));
    SpringLedger ledger(world, 1000, max_depenetration_velocity);
    Contact pair{ContactKind::vertex_face, 0, 1, 0, 0, {0, 0, 1, 2}, {1, -1, 0, 0}};
    pair.state = ContactState::answered;
    ledger.add_step(world, {pair}, dt);
    const double before = ledger.held();
    CHECK(before == doctest::Approx(0.5 * 1000 * 0.01));
    pair.feature_b = 1;
    pair.spring.rest_offset = -0.07;
    ledger.add_step(world, {pair}, dt);
    // less compressed, so no jump; as nothing pushes no work either
    CHECK(ledger.accounts().jumped == 0);
    CHECK(ledger.held() == doctest::Approx(0.5 * 1000 * 0.0009));
    CHECK(ledger.accounts().damped == doctest::Approx(before - ledger.held()));
    pair.feature_b = 2;
    pair.spring.rest_offset = 0;
    ledger.add_step(world, {pair}, dt);
    CHECK(ledger.accounts().jumped == doctest::Approx(before - 0.5 * 1000 * 0.0009));
    CHECK(ledger.accounts().died == 0);
    CHECK(ledger.accounts().lifted == 0);
}

TEST_CASE(
    "spring ledger: of an implicit spring each joule is in an account, and the step's damping is k (change of depth)^2 / 2")
{
    World world = points_in_ground(0, {0, -1, 0});
    Solver solver;
    solver.append(StepStage::detect, "all vertices", [](World&, Contacts& contacts, double) {
        for (int vertex = static_cast<int>(contacts.size()); vertex < 3; ++vertex) {
            contacts.push_back(on_ground(vertex));
            contacts.back().state = ContactState::waiting;
        }
    });
    solver.append(StepStage::respond, "springs", [](World& bodies, Contacts& contacts, double step) {
        for (Contact& pair : contacts)
            pair.impulse =
                -pair.spring.stiffness * step / (1 + pair.spring.stiffness * step * step) *  // points of 1 kg
                std::min(0.0, bodies.bodies[0]->positions_t1()[pair.feature_a].y()) * Vec3::UnitY();
    });
    SpringLedger ledger(world, 1000, max_depenetration_velocity);
    Contacts contacts;
    const double start = total_energy(world).total();
    double stepping = 0, damping = 0, before = 0;
    for (int step = 0; step < 8; ++step) {
        const Vec3 velocity = world.bodies[0]->mean_velocity();
        advance(world, contacts, solver, dt);
        ledger.add_step(world, contacts, dt);
        const double depth = std::min(0.0, world.bodies[0]->positions_t0()[0].y());
        damping += 3 * 0.5 * 2000 * std::pow(depth - std::exchange(before, depth), 2);
        stepping += 0.5 * world.bodies[0]->mass() *
                    (world.bodies[0]->mean_velocity() - velocity).squaredNorm();
        const SpringAccounts& sums = ledger.accounts();
        CHECK(sums.damped == doctest::Approx(damping).epsilon(1e-12));
        CHECK(ledger.held() == doctest::Approx(-sums.pushed - damping).epsilon(1e-12));
        CHECK(total_energy(world).total() - start == doctest::Approx(sums.pushed - stepping).epsilon(1e-12));
    }
    CHECK(stepping > 0.01);
}
