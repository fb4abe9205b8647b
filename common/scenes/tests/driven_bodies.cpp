#include "common/geometry/tests/complaint.hpp"
#include "common/scenes/scene_reader.hpp"
#include "common/scenes/tests/steps.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/rigid_body.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace enduring;

namespace {

const std::string text = R"({
  "name": "driven", "gravity": [0, -10, 0], "dt": 0.01, "duration": 1,
  "planes": [{"name": "ground", "point": [0, -90, 0]}],
  "bodies": [
    {"name": "table", "type": "static", "shape": {"box": {"size": [2, 1, 2]}}, "position": [0, 20, 0]},
    {"name": "brick", "type": "rigid", "shape": {"box": {"size": [0.5, 0.3, 0.2]}}, "mass": 2,
     "position": [1, 2, 3], "rotation": {"axis": [0, 0, 1], "angle_deg": 90}},
    {"name": "jelly", "type": "deformable", "shape": {"bar": {"size": [1, 1, 1]}}, "mass": 3, "young": 1e5,
     "poisson": 0.3, "position": [0, -20, 0]}
  ]
})";

Scene driven(const std::string& patch = "") { return read_scene(text, patch, "driven.json", {}); }

std::string complaint(const std::string& patch)
{
    return complaint_of([&] { driven(patch); });
}

const RigidMotion& brick_of(const Scene& scene)
{
    return dynamic_cast<const RigidBody&>(*scene.world.bodies[1]).motion();
}

}  // namespace

TEST_CASE("scene: a body with constant given motion moves and turns about its centre")
{
    Scene scene = driven(
        R"({"/bodies/table/motion": {"velocity": [1, 0, 0], "angular_velocity": [0, 2, 0], "centre": [1, 20, 1]}})");
    const Vec3 placed(-1, 19.5, -1), centre(1, 20, 1);
    CHECK(scene.world.bodies[0]->positions_t0()[0] == placed);
    step(scene, 30);
    const Vec3 expected = centre + Vec3(0.3, 0, 0) +
                          Eigen::AngleAxisd(0.6, Vec3::UnitY()) * (placed - centre);
    CHECK((scene.world.bodies[0]->positions_t0()[0] - expected).norm() < 1e-12);
    CHECK(scene.world.bodies[0]->is_static());
}

TEST_CASE(
    "scene: a table of given motion is followed from before time 0, about the shape's origin if no centre is given")
{
    Scene scene = driven(R"({"/bodies/table/motion": {"table": [
        {"time": -1, "displacement": [0, -1, 0]},
        {"time": 0, "displacement": [0, 1, 0], "turn": {"axis": [0, 3, 0], "angle_deg": 90}},
        {"time": 0.1, "turn": {"axis": [0, 1, 0], "angle_deg": 720}}]}})");
    const Vec3 corner(-1, -0.5, -1), quarter(-1, -0.5, 1);
    CHECK((scene.world.bodies[0]->positions_t0()[0] - Vec3(0, 21, 0) - quarter).norm() < 1e-12);
    step(scene, 10);
    CHECK((scene.world.bodies[0]->positions_t0()[0] - Vec3(0, 20, 0) - corner).norm() < 1e-12);
}

TEST_CASE("scene: a row of given motion may give its velocities, and a motion may end")
{
    Scene scene = driven(R"({"/bodies/table/motion": {"until": 0.04, "table": [
        {"time": 0, "velocity": [3, 0, 0], "angular_velocity": [0, 2, 0]},
        {"time": 1, "displacement": [3, 0, 0], "velocity": [3, 0, 0], "turn": {"axis": [0, 2, 0], "angle_deg": 114.59155902616465},
         "angular_velocity": [0, 2, 0]}]}})");
    const Vec3 placed = scene.world.bodies[0]->positions_t0()[0], middle(0, 20, 0);
    const auto expected = [&](double time) -> Vec3 {
        return middle + Vec3(3 * time, 0, 0) + Eigen::AngleAxisd(2 * time, Vec3::UnitY()) * (placed - middle);
    };
    CHECK((scene.world.bodies[0]->velocity(0) - Vec3(3, 0, 0) - Vec3(0, 2, 0).cross(placed - middle)).norm() <
          1e-12);
    step(scene, 3);
    CHECK((scene.world.bodies[0]->positions_t0()[0] - expected(0.03)).norm() < 1e-12);
    step(scene, 3);
    CHECK((scene.world.bodies[0]->positions_t0()[0] - expected(0.04)).norm() < 1e-12);
    CHECK(scene.world.bodies[0]->velocity(0) == Vec3::Zero());
}

TEST_CASE(
    "scene: forces act in the world's or the shape's axes, at a point of the shape, and over a table of times")
{
    // the shape's x is the world's y
    Scene scene = driven(R"({"gravity": [0, 0, 0], "/bodies/brick/forces": [
        {"force": [4, 0, 0], "axes": "body"},
        {"force": [0, 0, 6], "point": [0.25, 0, 0]},
        {"table": [{"time": 0, "force": [2, 0, 0]}, {"time": 0.005, "torque": [0, 0, 1]}]}]})");
    step(scene, 1);
    CHECK((brick_of(scene).velocity() - Vec3(0.5 * 2 * 0.005, 4 * 0.01, 6 * 0.01) / 2).norm() < 1e-14);
    // in the world the point is at (0, 0.25, 0) from the centre
    const Vec3 momentum = brick_of(scene).angular_momentum(brick_of(scene).centre());
    CHECK((momentum - Vec3(0.25 * 6 * 0.01, 0, 0.5 * 1 * 0.005)).norm() < 1e-14);
}

TEST_CASE("scene: a force on a soft body is spread over it")
{
    Scene scene = driven(
        R"({"/bodies/jelly/forces": [{"force": [0, 36, 0]}, {"table": [{"time": 0, "force": [3, 0, 0]}, {"time": 1, "force": [3, 0, 0]}]}]})");
    step(scene, 5);
    CHECK((scene.world.bodies[2]->mean_velocity() - 0.05 * Vec3(1, 2, 0)).norm() < 1e-9);
    const auto& soft = dynamic_cast<const DeformableBody&>(*scene.world.bodies[2]);
    CHECK(soft.energy(Vec3::Zero()).elastic < 1e-12);
}

TEST_CASE("scene: nodes of a soft body in a box or a ball move as given, about a centre in the world")
{
    Scene scene = driven(R"({"gravity": [0, 0, 0], "/bodies/jelly/driven": [
        {"min": [0.4, -9, -9], "motion": {"velocity": [2, 0, 0]}},
        {"ball": {"centre": [-0.5, 0.5, 0.5], "radius": 0.1}, "motion": {"angular_velocity": [0, 0, 1], "centre": [-0.5, -20, 0]}}]})");
    const auto& soft = dynamic_cast<const DeformableBody&>(*scene.world.bodies[2]).elastic();
    const NodalVectors start = soft.positions();
    step(scene, 10);
    int pulled = 0, turned = 0;
    for (int node = 0; node < soft.node_count(); ++node) {
        const Vec3 from = start.col(node), now = soft.positions().col(node);
        if (from.x() > 0.4 && ++pulled)
            CHECK((now - from - Vec3(0.2, 0, 0)).norm() < 1e-12);
        if ((from - Vec3(-0.5, -19.5, 0.5)).norm() < 0.1 && ++turned)
            CHECK((now - Vec3(-0.5, -20, 0) - Eigen::AngleAxisd(0.1, Vec3::UnitZ()) * Vec3(0, 0.5, 0.5))
                      .norm() < 1e-12);
    }
    CHECK(pulled == 9);
    CHECK(turned == 1);
    CHECK(complaint(R"({"/bodies/jelly": {"fixed": {"max": [-0.4, 9, 9]}, "driven": [
        {"ball": {"centre": [-0.5, 0, 0], "radius": 0.1}, "motion": {}}]}})") ==
          "driven.json: /bodies/2/driven/0: a node in this region is fixed or driven already");
    CHECK(complaint(R"({"/bodies/jelly/driven": [{"min": [7, 0, 0], "motion": {}}]})") ==
          "driven.json: /bodies/2/driven/0: no node of the shape lies in this region");
    CHECK(complaint(R"({"/bodies/jelly/driven": [{}]})") ==
          "driven.json: /bodies/2/driven/0: the key \"motion\" is missing");
    CHECK(complaint(R"({"/bodies/jelly/fixed": {"ball": {"centre": [0, 0, 0], "radius": -1}}})")
              .find("driven.json: /bodies/2/fixed/ball/radius: expected a number from 0") == 0);
}

TEST_CASE("scene: gravity is switched off for one body alone")
{
    Scene scene = driven(R"({"/bodies/brick/gravity": false})");
    step(scene, 3);
    CHECK(brick_of(scene).velocity().isZero(0));
    CHECK(scene.world.bodies[2]->mean_velocity().y() == doctest::Approx(-0.3));
}

TEST_CASE("scene: locked directions are world axes, by their letters")
{
    Scene scene = driven(R"({"/bodies/brick": {"angular_velocity": [0, 3, 0],
        "locked": {"translation": ["y"], "rotation": ["x", "z"]}, "forces": [{"force": [2, 0, 0], "torque": [5, 0, 5]}]}})");
    step(scene, 10);
    CHECK((brick_of(scene).velocity() - Vec3(0.1, 0, 0)).norm() < 1e-14);
    CHECK((brick_of(scene).angular_velocity() - Vec3(0, 3, 0)).norm() < 1e-12);
    CHECK(complaint(R"({"/bodies/brick": {"velocity": [1, 0, 0], "locked": {"translation": ["x"]}}})") ==
          "driven.json: /bodies/1: rigid body: it moves along or about an axis that is held");
}

TEST_CASE("scene: locked directions are those of the body where it says so, as it lies at the start")
{
    // the shape's y is the world's -x
    Scene scene = driven(R"({"/bodies/brick": {"angular_velocity": [3, 0, 0], "gravity": false,
        "locked": {"axes": "body", "translation": ["y"], "rotation": ["x", "z"]},
        "forces": [{"force": [2, 4, 0], "torque": [0, 5, 5]}]}})");
    step(scene, 10);
    CHECK((brick_of(scene).velocity() - Vec3(0, 0.2, 0)).norm() < 1e-12);
    CHECK((brick_of(scene).angular_velocity() - Vec3(3, 0, 0)).norm() < 1e-12);
    CHECK(
        complaint(
            R"({"/bodies/brick": {"velocity": [1, 0, 0], "locked": {"axes": "body", "translation": ["y"]}}})") ==
        "driven.json: /bodies/1: rigid body: it moves along or about an axis that is held");
    CHECK(complaint(R"({"/bodies/brick/locked": {"axes": "own"}})").find("/bodies/1/locked/axes") !=
          std::string::npos);
}

TEST_CASE("scene: a point about which a body is locked is the shape's, and holds all translations")
{
    // the shape's x is the world's y
    Scene scene = driven(R"({"/bodies/brick": {"angular_velocity": [0, 0, 3],
        "locked": {"about": [0.25, 0, 0], "rotation": ["x", "y"]}}})");
    const Vec3 pin(1, 2.25, 3);
    CHECK((brick_of(scene).pose().position - pin).norm() < 1e-14);
    CHECK((brick_of(scene).centre() - Vec3(1, 2, 3)).norm() < 1e-14);
    CHECK((brick_of(scene).velocity() - Vec3(0.75, 0, 0)).norm() < 1e-14);
    step(scene, 5);
    CHECK((brick_of(scene).centre() - pin).norm() == doctest::Approx(0.25).epsilon(1e-12));
    CHECK(brick_of(scene).centre().z() == doctest::Approx(3));
    CHECK(
        complaint(R"({"/bodies/brick/locked": {"about": [0, 0, 0], "translation": ["x"]}})") ==
        "driven.json: /bodies/1/locked/translation: stands beside \"about\", which holds all translations of a point");
    CHECK(
        complaint(R"({"/bodies/brick": {"velocity": [0, 0, 0], "locked": {"about": [0, 0, 0]}}})") ==
        "driven.json: /bodies/1/velocity: follows from the \"angular_velocity\" of a body that is locked \"about\" a point");
    CHECK(complaint(R"({"/bodies/brick/locked": {"about": [0, 0]}})")
              .find("driven.json: /bodies/1/locked/about") == 0);
}

TEST_CASE("scene: materials give density and friction, a pair by its own entry or by the geometric mean")
{
    const Scene scene =
        driven(R"({"contact": {"friction": {"model": "mass_splitting", "mu_s": 0.25, "mu_d": 0.16}},
        "materials": [{"name": "ice", "density": 900, "mu_s": 0.04, "mu_d": 0.01}, {"name": "rubber", "mu_s": 1}],
        "material_pairs": [{"between": ["rubber", "ice"], "mu_s": 0.3}],
        "/bodies/brick": {"mass": null, "material": "ice"}, "/bodies/jelly/material": "rubber",
        "/planes/ground/material": "rubber"})");
    CHECK(scene.world.bodies[1]->mass() == doctest::Approx(900 * 0.03));
    CHECK(scene.world.bodies[0]->material() == MaterialFriction::none);
    CHECK(scene.world.bodies[1]->material() == 0);
    CHECK(scene.world.bodies[2]->material() == 1);
    CHECK(scene.world.planes[0].material == 1);
    const auto check = [&](int one, int other, double mu_s, double mu_d) {
        CAPTURE(one);
        CAPTURE(other);
        for (const FrictionCoefficients& mu :
             {scene.world.friction.of(one, other), scene.world.friction.of(other, one)}) {
            CHECK(mu.mu_s == doctest::Approx(mu_s));
            CHECK(mu.mu_d == doctest::Approx(mu_d));
        }
    };
    check(0, 0, 0.04, 0.01);
    check(1, 1, 1, 0.16);    // mu_d of the scene
    check(0, 1, 0.3, 0.04);  // the pair's own, and the mean
    check(-1, 0, 0.1, 0.04);
    check(-1, 1, 0.5, 0.16);
    check(-1, -1, 0.25, 0.16);
}

TEST_CASE(
    "scene: a coefficient of restitution is the scene's, a material's, or a pair's, else the geometric mean")
{
    CHECK(!driven("{}").world.restitution.any());
    CHECK(driven(R"({"contact": {"restitution": 0.25}})").world.restitution.of(-1, -1) == 0.25);
    const MaterialRestitution e = driven(R"({"contact": {"restitution": 0.25},
        "materials": [{"name": "clay", "restitution": 0}, {"name": "steel", "restitution": 0.64}, {"name": "wood"}],
        "material_pairs": [{"between": ["wood", "steel"], "restitution": 0.5}]})")
                                      .world.restitution;
    const auto check = [&](int one, int other, double expected) {
        CAPTURE(one);
        CAPTURE(other);
        CHECK(e.of(one, other) == doctest::Approx(expected));
        CHECK(e.of(other, one) == doctest::Approx(expected));
    };
    check(1, 1, 0.64);
    check(2, 2, 0.25);
    check(-1, 1, 0.4);
    check(1, 2, 0.5);
    check(0, 1, 0);
    check(-1, -1, 0.25);
    CHECK(complaint(R"({"contact": {"restitution": 1.1}})") ==
          "driven.json: /contact/restitution: expected a number from 0 to 1, found 1.1");
    CHECK(complaint(R"({"materials": [{"name": "ice", "restitution": -0.1}]})") ==
          "driven.json: /materials/0/restitution: expected a number from 0 to 1, found -0.1");
}

TEST_CASE("scene: mistakes in what drives a body are named with their place")
{
    CHECK(
        complaint(R"({"/bodies/table/motion": {"velocity": [0, 20000, 0]}})") ==
        "driven.json: /bodies/0/motion/velocity/1: expected a number from -10000 to 10000 [m/s], found 20000");
    CHECK(
        complaint(R"({"/bodies/table/motion": {"table": [{"time": 0}, {"time": 0}]}})") ==
        "driven.json: /bodies/0/motion/table/1/time: is not a microsecond or more later than that of the row before");
    CHECK(complaint(R"({"/bodies/table/motion": {"table": [{"time": 0}]}})")
              .find("driven.json: /bodies/0/motion/table: expected a list of 2 to 100000 entries") == 0);
    CHECK(complaint(
              R"({"/bodies/table/motion": {"velocity": [0, 0, 0], "table": [{"time": 0}, {"time": 1}]}})") ==
          "driven.json: /bodies/0/motion/velocity: stands beside \"table\"; one of the two is enough");
    CHECK(
        complaint(
            R"({"/bodies/table/motion": {"table": [{"time": 0, "velocity": [0, 2e4, 0]}, {"time": 1}]}})") ==
        "driven.json: /bodies/0/motion/table/0/velocity/1: expected a number from -10000 to 10000 [m/s], found 20000.0");
    CHECK(
        complaint(
            R"({"/bodies/table/motion": {"table": [{"time": 0}, {"time": 1, "turn": {"axis": [0, 1, 0], "angle_deg": 720}, "angular_velocity": [1, 0, 0]}]}})") ==
        "driven.json: /bodies/0/motion/table/1/angular_velocity: is not about the axis of \"turn\", and after whole turns no other axis can follow");
    CHECK(complaint(R"({"/bodies/table/motion": {"until": 0}})")
              .find("driven.json: /bodies/0/motion/until: expected a number above 0") == 0);
    CHECK(complaint(R"({"/bodies/table": {"motion": {}, "surface_velocity": [1, 0, 0]}})") ==
          "driven.json: /bodies/0/surface_velocity: stands beside \"motion\"; a body has one of the two");
    CHECK(complaint(R"({"/bodies/brick/motion": {}})").find("driven.json: /bodies/1/motion: unknown key") ==
          0);
    CHECK(complaint(R"({"/bodies/table/forces": []})").find("driven.json: /bodies/0/forces: unknown key") ==
          0);
    CHECK(
        complaint(R"({"/bodies/brick/forces": [{"force": [1e10, 0, 0]}]})") ==
        "driven.json: /bodies/1/forces/0/force/0: expected a number from -1e+09 to 1e+09 [N], found 10000000000.0");
    CHECK(complaint(R"({"/bodies/brick/forces": [{"axes": "mine"}]})") ==
          "driven.json: /bodies/1/forces/0/axes: expected one of \"world\", \"body\", found \"mine\"");
    CHECK(complaint(
              R"({"/bodies/brick/forces": [{"force": [1, 0, 0], "table": [{"time": 0}, {"time": 1}]}]})") ==
          "driven.json: /bodies/1/forces/0/force: stands beside \"table\"; one of the two is enough");
    CHECK(complaint(R"({"/bodies/brick/locked": {"rotation": ["w"]}})") ==
          "driven.json: /bodies/1/locked/rotation/0: expected one of \"x\", \"y\", \"z\", found \"w\"");
    CHECK(complaint(R"({"/bodies/brick/locked": {"rotation": ["x", "y", "x"]}})") ==
          "driven.json: /bodies/1/locked/rotation/2: is locked twice");
    CHECK(complaint(R"({"/bodies/brick/gravity": 0})") ==
          "driven.json: /bodies/1/gravity: expected true or false, found 0");
    CHECK(complaint(R"({"/bodies/brick/material": "ice"})") ==
          "driven.json: /bodies/1/material: there is no material \"ice\" in \"materials\"");
    CHECK(complaint(R"({"materials": [{"name": "ice"}, {"name": "ice"}]})") ==
          "driven.json: /materials/1/name: another material is already called \"ice\"");
    CHECK(complaint(R"({"materials": [{"name": "ice", "mu_s": 0.1, "mu_d": 0.2}]})")
              .find("driven.json: /materials/0: \"mu_d\" is above \"mu_s\"") == 0);
    CHECK(
        complaint(
            R"({"materials": [{"name": "a"}], "material_pairs": [{"between": ["a", "a"]}, {"between": ["a", "a"]}]})") ==
        "driven.json: /material_pairs/1/between: another entry has the same two materials");
}

TEST_CASE("scene: surface velocity arrives")
{
    const Scene scene = driven(R"({"/bodies/table/surface_velocity": [1, 0, -2]})");
    CHECK(scene.world.bodies[0]->surface_velocity() == Vec3(1, 0, -2));
}
