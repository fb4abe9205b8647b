#include "chapters/02_collision_detection/solver.hpp"
#include "chapters/02_collision_detection/candidate_search.hpp"
#include "common/experiments/run/run.hpp"
#include "common/simulation/tests/block_of_any_kind.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace enduring;

namespace {

/// The scene's pairs of features after some steps, and the speed of the body that flies.
struct Flight {
    Contacts pairs;
    Vec3 velocity;
};

Flight flight(int steps)
{
    Scene scene = load_scene(scene_file("fast_plate"));
    RunLimits limits;
    limits.steps = steps;
    const Contacts contacts = run(scene, chapter02_solver(scene.contact), {}, limits).contacts;
    return {contacts, body_named(scene.world, "bullet").mean_velocity()};
}

}  // namespace

TEST_CASE(
    "collision list: a tetrahedron that passes a plate within a step is listed with both sides of it, each pair once")
{
    const Flight end = flight(6);
    std::vector<int> faces;
    for (const Contact& pair : end.pairs)
        if (pair.kind == ContactKind::vertex_face)
            faces.push_back(pair.feature_b);
    std::sort(faces.begin(), faces.end());
    CHECK(std::unique(faces.begin(), faces.end()) - faces.begin() >= 2);  // into one side, out of the other
    for (std::size_t i = 0; i < end.pairs.size(); ++i)
        for (std::size_t j = i + 1; j < end.pairs.size(); ++j) {
            const Contact &one = end.pairs[i], &other = end.pairs[j];
            CHECK((one.kind != other.kind || one.body_a != other.body_a || one.feature_a != other.feature_a ||
                   one.feature_b != other.feature_b));
        }
}

TEST_CASE("collision list: nothing answers what it lists")
{
    const Flight end = flight(6);
    REQUIRE_FALSE(end.pairs.empty());
    for (const Contact& pair : end.pairs)
        CHECK(pair.held());
    CHECK((end.velocity - Vec3(4, -36 - 9.81 * 0.06, 0)).norm() < 1e-12);
}

TEST_CASE(
    "candidate search: of a thousand bodies only those are looked at whose boxes overlap in this step, and no two static ones")
{
    World world;
    const auto add = [&](tests::BodyKind kind, const Vec3& place) {
        world.bodies.push_back(
            tests::block("block " + std::to_string(world.bodies.size()), kind, place, {0, -1, 0}));
    };
    const int rows = 20, columns = 25;
    for (int i = 0; i < rows * columns; ++i) {
        const Vec3 place(2.0 * (i % rows), 0, 2.0 * (i / rows));
        add(tests::BodyKind::still, place);
        // every second one in its static block
        add(tests::BodyKind::rigid, place + Vec3(0, i % 2 == 0 ? 0.85 : 1.5, 0));
    }
    add(tests::BodyKind::still, {0, 0, 0});  // in another static block, and in the rigid one above that
    const auto pairs_of_a_step = [&](CandidateSearch& search, const Vec3& gravity) {
        for (const auto& body : world.bodies)
            body->predict(gravity, 0.01);
        search.find_candidates(world);
        for (const auto& body : world.bodies)
            body->commit(0.01);
        return search.body_pair_count();
    };
    CandidateSearch search;
    CHECK(pairs_of_a_step(search, {0, 1e5, 0}) == rows * columns / 2 + 1);
    CHECK(pairs_of_a_step(search, {0, 1e5, 0}) == 0);  // 10 m higher
}
