#include "chapters/07_implicit_contact/implicit_contact.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/energy.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

using namespace enduring;

namespace {

constexpr double dt = 0.01;

World three_bars(double young)
{
    World world;
    for (int i = 0; i < 3; ++i) {
        DeformableSettings settings;
        settings.material = {.young = young, .poisson = 0.3};
        settings.position = Vec3(0, 0, i);
        world.bodies.push_back(std::make_unique<DeformableBody>("bar " + std::to_string(i + 1),
                                                                bar({1, 0.2, 0.2}, {4, 1, 1}), settings));
    }
    return world;
}

void predict(World& world)
{
    for (const auto& body : world.bodies)
        body->predict(Vec3::Zero(), dt);
}

/// Three soft bars, the middle one of which a push has bent since all have settled.
World bars_of_which_one_is_pushed()
{
    World world = three_bars(1e5);
    predict(world);
    find_elastic_ends(world, dt);
    Body& body = *world.bodies[1];
    const std::vector<int> end{0};
    body.contact_coordinates().apply_contact_impulse(end, Vec3(0, 50, 0));
    body.update_prediction(dt);
    return world;
}

}  // namespace

TEST_CASE("elastic ends: of several bodies the one counts that misses most, whichever place it has")
{
    for (const std::vector<int>& order : {std::vector{0, 1}, std::vector{1, 2}}) {
        World world = bars_of_which_one_is_pushed();
        Island island;
        island.bodies = order;
        CHECK(follows_end(world, island));
        CHECK(approach_ends(world, island, dt) > small_imbalance);
    }
}

TEST_CASE("elastic ends: soft bodies settle before chapter 7's solver looks for pairs")
{
    World world = bars_of_which_one_is_pushed();
    Contacts contacts;
    bool has_settled = false;
    advance(world, contacts, chapter07_solver({}), dt, [&](const std::string& pass) {
        has_settled = has_settled || pass == "find elastic ends";
        for (const auto& body : world.bodies)
            if (pass != "commit")
                CHECK(dynamic_cast<const DeformableBody&>(*body).elastic().approaches_end() == has_settled);
    });
    CHECK(has_settled);
}

TEST_CASE("elastic ends: bodies of an island that have not settled in this step are left alone")
{
    World world = bars_of_which_one_is_pushed();
    world.bodies[0]->predict(Vec3::Zero(), dt);
    const auto velocity = [&] {
        return world.bodies[0]->contact_coordinates().contact_velocity(std::vector{0, 1, 2, 3});
    };
    world.bodies[0]->contact_coordinates().apply_contact_impulse(std::vector{0}, Vec3(0, 50, 0));
    world.bodies[0]->update_prediction(dt);
    const Eigen::VectorXd before = velocity();
    Island alone, island;
    alone.bodies = {0};
    island.bodies = {0, 1, 2};
    CHECK_FALSE(follows_end(world, alone));
    CHECK(follows_end(world, island));
    CHECK(approach_ends(world, island, dt) > small_imbalance);
    CHECK(velocity() == before);
    CHECK(world.attempt.trouble == StepTrouble::none);
}

TEST_CASE("elastic ends: a body that is inside out takes whole steps and gains no energy")
{
    // Its frames jump between two ends, however short the step is, so halves would settle no better.
    for (const unsigned seed : {1u, 2u, 3u}) {
        CAPTURE(seed);
        World world = three_bars(1e4);
        world.bodies.resize(1);  // nothing touches it
        world.gravity.setZero();
        Body& bar = *world.bodies[0];
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> push(-400, 400);  // N s, on a bar of 40 kg
        for (int vertex = 0; vertex < bar.surface().vertex_count(); ++vertex)
            bar.apply_impulse(vertex, Vec3(push(random), push(random), push(random)));
        int inverted = 0;
        Contacts contacts;
        const Solver solver = chapter07_solver({});
        for (int i = 0; i < 20; ++i) {
            const double before = total_energy(world).total();
            advance(world, contacts, solver, dt);
            CHECK(total_energy(world).total() <= 1.001 * before);
            inverted = std::max(inverted, bar.inverted_elements());
        }
        REQUIRE(inverted > 0);
        CHECK(world.thrown_away == 0);
    }
}
