#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/tests/run_until.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace enduring;

namespace {

constexpr double until = 0.2;

/// A bar of 1 x 0.2 x 0.2 m whose nodes at x < left and x > right are gripped until a time; the right ones
/// move.
World gripped_bar(double left, double right, const GivenMotion& motion, double freed = until,
                  ImpulseResponse response = ImpulseResponse::implicit)
{
    const TetrahedralMesh mesh = bar({1, 0.2, 0.2}, {4, 1, 1});
    DeformableSettings settings;
    settings.material = {.young = 1e5, .poisson = 0.3, .density = 1000};
    settings.impulse_response = response;
    DrivenNodes stay{{}, GivenMotion::steady(Vec3::Zero(), Vec3::Zero()), Vec3::Zero(), freed},
        moved{{}, motion, Vec3::Zero(), freed};
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
        if (mesh.nodes[node].x() > right)
            moved.nodes.push_back(static_cast<int>(node));
        else if (mesh.nodes[node].x() < left)
            stay.nodes.push_back(static_cast<int>(node));
    settings.driven_nodes = {stay, moved};
    World world;
    world.gravity.setZero();
    world.bodies.push_back(std::make_unique<DeformableBody>("bar", mesh, settings));
    return world;
}

/// Throws each first attempt at a step away.
Solver halving()
{
    Solver solver;
    solver.max_halvings = 1;
    solver.append(StepStage::finish, "trouble", [](World& world, Contacts&, double) {
        if (world.attempt.may_be_halved)
            world.attempt.trouble = StepTrouble::unsolved;
    });
    return solver;
}

}  // namespace

TEST_CASE("freed nodes: a bar that was moved as a whole flies on with the velocity that it had")
{
    for (const Solver& solver : {Solver{}, halving()}) {
        World world = gripped_bar(-9, -9, GivenMotion::steady({1, 2, 0}, Vec3::Zero()));
        const Body& body = *world.bodies[0];
        run_until(world, until, 0.01, solver);
        const double driven = world.driven, energy = total_energy(world).total();
        run_until(world, 2 * until, 0.01, solver);
        CHECK((body.linear_momentum() - 40 * Vec3(1, 2, 0)).norm() < 1e-9);
        CHECK((body.centre() - 2 * until * Vec3(1, 2, 0)).norm() < 1e-9);
        CHECK(world.driven == doctest::Approx(driven).epsilon(1e-12));
        CHECK(total_energy(world).total() == doctest::Approx(energy).epsilon(1e-9));
    }
}

TEST_CASE(
    "freed nodes: a bar that was pulled and is let go has the energy that it held, and no momentum but its own")
{
    for (const double dt : {0.01, 0.003}) {
        CAPTURE(dt);
        World world = gripped_bar(
            -0.49, 0.49,
            GivenMotion::through({{0, Vec3::Zero(), Vec3::Zero()}, {0.1, Vec3(0.2, 0, 0), Vec3::Zero()}}));
        run_until(world, until, dt);
        const double held = total_energy(world).total(), driven = world.driven;
        CHECK(held > 30);
        const Vec3 momentum = world.bodies[0]->linear_momentum();
        double most = 0;
        bool moved = false;
        Contacts contacts;
        while (world.time < 2 * until) {
            advance(world, contacts, {}, dt);
            most = std::max(most, total_energy(world).total());
            moved = moved || total_energy(world).kinetic > 0.1 * held;
        }
        CHECK(most <= held * (1 + 1e-6));
        CHECK(moved);
        CHECK(world.driven == doctest::Approx(driven).epsilon(1e-12));
        CHECK((world.bodies[0]->linear_momentum() - momentum).norm() < 1e-9);
    }
}

TEST_CASE("freed nodes: they are held in each step that begins before their time, and in no later one")
{
    const GivenMotion motion = GivenMotion::steady({1, 0, 0}, Vec3::Zero());
    for (const double freed : {0.195, 0.2, 0.205}) {
        CAPTURE(freed);
        World world = gripped_bar(-9, 0.49, motion, freed);
        // seen by an impulse, which nothing that is held feels
        const auto is_held = [&] {
            Contacts contacts;
            advance(world, contacts, {}, 0.01);
            return world.bodies[0]
                ->inverse_mass(static_cast<int>(world.bodies[0]->positions_t0().size()) - 1)
                .isZero(1e-9);
        };
        run_until(world, 0.18, 0.01);
        CHECK(is_held());
        CHECK(is_held() == (freed > 0.19));
        CHECK(is_held() == (freed > 0.2));
        CHECK(!is_held());
    }
}

TEST_CASE("freed nodes: a bar that was held and is free answers impulses as one that never was")
{
    for (const ImpulseResponse response : {ImpulseResponse::lumped, ImpulseResponse::implicit}) {
        const GivenMotion rest = GivenMotion::steady(Vec3::Zero(), Vec3::Zero());
        World held = gripped_bar(-0.49, 0.49, rest, until, response),
              free = gripped_bar(-9, 9, rest, until, response);
        const auto ask = [&] {
            for (World* world : {&held, &free})
                for (const int vertex : {0, 7, 12})
                    world->bodies[0]->inverse_mass(vertex);
        };
        run_until(held, until / 2, 0.01);
        run_until(free, until / 2, 0.01);
        ask();
        run_until(held, until, 0.01);
        run_until(free, until, 0.01);
        for (World* world : {&held, &free}) {
            world->bodies[0]->set_time(until);
            world->bodies[0]->predict(Vec3::Zero(), 0.01);
        }
        for (const int vertex : {0, 7, 12})
            CHECK((held.bodies[0]->inverse_mass(vertex) - free.bodies[0]->inverse_mass(vertex)).norm() <
                  1e-5 * free.bodies[0]->inverse_mass(vertex).norm());
        held.bodies[0]->apply_impulse(0, {0, 1, 0});
        free.bodies[0]->apply_impulse(0, {0, 1, 0});
        held.bodies[0]->update_prediction(0.01);
        free.bodies[0]->update_prediction(0.01);
        CHECK((held.bodies[0]->velocity(0) - free.bodies[0]->velocity(0)).norm() <
              1e-6 * free.bodies[0]->velocity(0).norm());
    }
}

TEST_CASE(
    "freed nodes: what is held takes a force on it, and so does nothing else, and a force at a point turns the body")
{
    World world = gripped_bar(-0.49, 0.49, GivenMotion::steady({0.1, 0, 0}, Vec3::Zero()));
    auto& body = dynamic_cast<DeformableBody&>(*world.bodies[0]);
    std::vector<NodeWeight> end;
    for (int node = 0; node < body.elastic().node_count(); ++node)
        if (body.elastic().positions()(0, node) > 0.49)
            end.push_back({node, 0.25});
    REQUIRE(end.size() == 4);
    World other = gripped_bar(-0.49, 0.49, GivenMotion::steady({0.1, 0, 0}, Vec3::Zero()));
    body.add_force(TimedVector(Vec3(30, 0, 50)), end);
    run_until(world, until, 0.01);
    run_until(other, until, 0.01);
    CHECK(world.driven == doctest::Approx(other.driven).epsilon(1e-9));

    const Vec3 momentum = body.linear_momentum();
    const double turning = body.angular_momentum(Vec3::Zero()).y();
    run_until(world, until + 0.05, 0.01);
    CHECK((body.linear_momentum() - momentum - 0.05 * Vec3(30, 0, 50)).norm() < 1e-9);
    // the lever shortens as the bar comes back
    CHECK(body.angular_momentum(Vec3::Zero()).y() - turning ==
          doctest::Approx(-50 * 0.05 * 0.5).epsilon(0.06));
}

TEST_CASE(
    "freed nodes: a state from after their time is taken up by a body that is made anew, and one from before")
{
    const GivenMotion motion = GivenMotion::steady({1, 0, 0}, Vec3::Zero());
    for (const double saved : {until / 2, until + 0.05}) {
        CAPTURE(saved);
        World first = gripped_bar(-0.49, 0.49, motion), second = gripped_bar(-0.49, 0.49, motion);
        run_until(first, saved, 0.01);
        run_until(second, saved < until ? 2 * until : 0.0, 0.01);  // was freed, and is held again
        restore_state(*second.bodies[0], state_of(*first.bodies[0]));
        second.time = first.time;
        run_until(first, 2 * until, 0.01);
        run_until(second, 2 * until, 0.01);
        for (std::size_t i = 0; i < first.bodies[0]->positions_t0().size(); ++i)
            CHECK((first.bodies[0]->positions_t0()[i] - second.bodies[0]->positions_t0()[i]).norm() < 1e-9);
    }
}
