#include "chapters/02_collision_detection/candidate_search.hpp"

#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/simulation/rigid_body.hpp"

#include <doctest/doctest.h>

#include <array>
#include <random>
#include <vector>

using namespace enduring;

namespace {

constexpr double dt = 0.01;

/// Balls and boxes that fly about, so near to each other that boxes overlap.
World thrown_bodies(std::mt19937& random)
{
    std::uniform_real_distribution<double> in(-1, 1);
    World world;
    for (int i = 0; i < 12; ++i) {
        SurfaceMesh mesh = i % 2 == 0 ? box({0.3, 0.3, 0.3}, {2, 2, 2}) : sphere(0.2, 1);
        const Vec3 place = 0.4 * Vec3(in(random), in(random), in(random));
        for (Vec3& vertex : mesh.vertices)
            vertex += place;
        world.bodies.push_back(std::make_unique<RigidBody>("body " + std::to_string(i), mesh,
                                                           mass_properties(mesh, 1000),
                                                           Vec3(in(random), in(random), in(random))));
    }
    return world;
}

using Candidate = std::array<int, 5>;

std::vector<Candidate> candidates_of(const CandidateSearch& search)
{
    std::vector<Candidate> all;
    search.visit_candidates(
        [&](int a, int vertex, int b, int face) {
            all.push_back({0, a, vertex, b, face});
        },
        [&](int a, int edge, int b, int other) {
            all.push_back({1, a, edge, b, other});
        });
    return all;
}

}  // namespace

TEST_CASE(
    "candidate search: where some bodies have another prediction, only theirs are collected again, and all are "
    "right")
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> in(-1, 1);
    World world = thrown_bodies(random);
    const std::vector<double> margins(world.bodies.size(), 0.01);
    CandidateSearch search;
    for (const auto& body : world.bodies)
        body->predict(world.gravity, dt);
    search.find_candidates(world, margins);
    for (int round = 0; round < 20; ++round) {
        std::vector<bool> moved(world.bodies.size());
        for (std::size_t i = 0; i < moved.size(); ++i)
            if (random() % 3 == 0) {
                moved[i] = true;
                auto& body = dynamic_cast<RigidBody&>(*world.bodies[i]);
                body.apply_impulse(0, body.mass() * 20 * Vec3(in(random), in(random), in(random)));
                body.update_prediction(dt);
            }
        search.refit_candidates(world, margins, moved);
        CandidateSearch afresh;
        afresh.find_candidates(world, margins);
        CHECK(!candidates_of(afresh).empty());
        CHECK(candidates_of(search) == candidates_of(afresh));
    }
}
