#include "chapters/13_other_solvers/near_features.hpp"

#include "chapters/07_implicit_contact/experiments/rest_scenes.hpp"
#include "chapters/07_implicit_contact/experiments/true_depth.hpp"
#include "chapters/13_other_solvers/tests/small_scenes.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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

void add_moved(Scene& scene, SurfaceMesh mesh, double flip, const Vec3& by)
{
    const Eigen::AngleAxisd turn(flip, Vec3::UnitX());
    for (Vec3& x : mesh.vertices)
        x = turn * x + by;
    scene.world.bodies.push_back(std::make_unique<RigidBody>("part", mesh, mass_properties(mesh, 1000)));
}

/// The deepest separation of all pairs [m].
double deepest(const Contacts& pairs, const Scene& scene)
{
    double deepest = 0;
    for (const Contact& pair : pairs)
        deepest = std::min(deepest, separation_t0(scene.world, pair));
    return deepest;
}

}  // namespace

TEST_CASE("near features: two dents that face each other are not inside each other")
{
    const SurfaceMesh hollow = bowl({1, 0.04, 0.5, 0, 20, 6, 2});
    for (const double gap : {1e-3, 1e-2}) {
        CAPTURE(gap);
        Scene scene = chapter07::scene_of({}, 0.01);
        scene.world.planes.clear();
        const double rim = 1.02 * std::cos(0.5);  // below the centre, in the middle of the wall
        add_moved(scene, hollow, 0, Vec3::Zero());
        add_moved(scene, hollow, std::numbers::pi, Vec3(0, -2 * rim + 0.041 + gap, 0));
        REQUIRE(chapter07::true_depth(scene.world) == 0);
        CHECK(deepest(pairs_of(scene), scene) == 0);
    }
}

TEST_CASE("near features: in a heap no edge is pushed out sideways, so it gains no energy")
{
    Scene scene = chapter07::scene_of(chapter07::loose_cubes(30, 3, 1), 0.01);
    const Solver solver = chapter13_solver("relaxation", scene.contact);
    Contacts contacts;
    double lowest = total_energy(scene.world).total(), gained = 0;
    for (int step = 0; step < 120; ++step) {
        advance(scene.world, contacts, solver, scene.dt);
        const double energy = total_energy(scene.world).total();
        lowest = std::min(lowest, energy);
        gained = std::max(gained, energy - lowest);
    }
    CHECK(gained <= 5);
}

TEST_CASE("near features: a soft bunny in its bowl meets no edge through a wall, so it gains no energy")
{
    Scene scene = load_scene(scene_file("bunny_bowl"),
                             R"({"/bodies/bunny/rayleigh": {"mass": 0, "stiffness": 0}})");
    const double first = total_energy(scene.world).total();
    double highest = first;
    const Solver solver = chapter13_solver("xpbd", scene.contact);
    Contacts contacts;
    for (int step = 0; step < 160; ++step) {
        advance(scene.world, contacts, solver, scene.dt);
        highest = std::max(highest, total_energy(scene.world).total());
    }
    CHECK(highest <= first + 1);
    CHECK((scene.world.bodies[1]->centre() - Vec3(-0.28, 0.73, -0.08)).norm() <= 0.1);  // up at its wall
}

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
    CHECK(chapter07::longest_displacement(scene.world, from) <= 0.02);
}
