#include "chapters/02_collision_detection/solver.hpp"
#include "common/experiments/run/run.hpp"

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
