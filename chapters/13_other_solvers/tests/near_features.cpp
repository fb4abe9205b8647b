#include "chapters/13_other_solvers/near_features.hpp"

#include "chapters/07_implicit_contact/experiments/rest_scenes.hpp"
#include "chapters/13_other_solvers/tests/small_scenes.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace enduring;

namespace {

Contacts pairs_of(Scene& scene)
{
    for (const auto& body : scene.world.bodies)
        body->stand_still();
    return NearFeatures().find(scene.world);
}

/// Two cubes, the upper one above the lower one by a gap, moved and turned about y.
Scene two_cubes(double gap, double moved, double turn_deg)
{
    Scene scene = chapter07::scene_of(
        {{10, Vec3(0, 0.5, 0), 0}, {10, Vec3(moved, 1.5 + gap, 0.3 * moved), turn_deg}}, 0.01);
    scene.world.planes.clear();
    return scene;
}

}  // namespace

TEST_CASE("near features: a cube on a cube has normals up and the gap as its separation, outside and inside")
{
    for (const double gap : {1e-3, 1e-6, 0.0, -1e-4, -3e-3})
        for (const double turn : {0.0, 7.0, 45.0})
            for (const double moved : {0.0, 0.1}) {
                CAPTURE(gap);
                CAPTURE(turn);
                CAPTURE(moved);
                Scene scene = two_cubes(gap, moved, turn);
                const Contacts pairs = pairs_of(scene);
                CHECK(pairs.size() >= 4);
                for (const Contact& pair : pairs) {
                    const double upper = pair.body_a == 1 ? 1 : -1;  // the normal points towards A
                    CHECK((pair.normal_t0 - Vec3(0, upper, 0)).norm() <= 1e-9);
                    CHECK(separation_t0(scene.world, pair) == doctest::Approx(gap).epsilon(1e-9));
                }
            }
}

TEST_CASE("near features: two cubes farther apart than they can come have no pair, and meet where they fly")
{
    Scene scene = two_cubes(0.5, 0, 7);
    CHECK(pairs_of(scene).empty());
    scene.world.bodies[1]->kick({}, (Eigen::VectorXd(6) << 0, -600, 0, 0, 0, 0).finished(), 0.01);
    scene.world.bodies[1]->update_prediction(0.01);  // 60 m/s
    CHECK(NearFeatures().find(scene.world).size() >= 4);
}

TEST_CASE("near features: a tip in a crack has a pair with each wall")
{
    Scene scene = chapter07::tip_in_crack(chapter07::Tip::wedge, 33, 60, 0.01);
    Contacts contacts;
    const Solver solver = chapter13_solver("relaxation", scene.contact);
    int at_both = 0;  // steps
    for (int step = 0; step < 100; ++step) {
        advance(scene.world, contacts, solver, scene.dt);
        double left = 0, right = 0;
        for (const Contact& contact : contacts) {
            left = std::min(left, contact.normal_t0.x());
            right = std::max(right, contact.normal_t0.x());
        }
        at_both += left < -0.5 && right > 0.5;
    }
    CHECK(at_both >= 5);
    CHECK(scene.world.bodies[1]->centre().y() >= 0.5);  // and it is not through
}

TEST_CASE("near features: vertices and edges inside a flat side have no pairs of their own")
{
    Scene scene = two_cubes(1e-3, 0, 0);
    const SurfaceMesh floor = box({4, 1, 4}, {8, 1, 8});
    scene.world.bodies.erase(scene.world.bodies.begin());
    SurfaceMesh moved = floor;
    for (Vec3& x : moved.vertices)
        x.y() += 0.5;
    scene.world.bodies.push_back(std::make_unique<StaticBody>(
        "floor", SurfaceTopology(static_cast<int>(moved.vertices.size()), moved.faces), moved.vertices));
    const Contacts pairs = pairs_of(scene);
    CHECK(std::all_of(pairs.begin(), pairs.end(), [](const Contact& pair) {
        return pair.kind == ContactKind::vertex_face && pair.body_a == 0;
    }));
    CHECK(pairs.size() == 4);
}

TEST_CASE("near features: stones of an arch that tilt against each other keep the pairs of both sides")
{
    Scene scene = chapter07::arch(20, 5, 0.01);
    const std::vector<Vec3> from = chapter07::centres_of(scene.world);
    run(scene, chapter13_solver("relaxation", scene.contact), 1);
    CHECK(chapter07::longest_displacement(scene.world, from) <= 0.1);
}
