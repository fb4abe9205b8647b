#include "common/geometry/tests/complaint.hpp"
#include "common/input/input_error.hpp"
#include "common/scenes/scene_reader.hpp"
#include "common/simulation/step.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <numbers>

using namespace enduring;

namespace {

/// Two boxes that lie in each other, a wall, and the joints that are given.
std::string scene_with(const std::string& joints)
{
    return R"({"name": "machine", "dt": 0.01, "duration": 1, "bodies": [
      {"name": "arm", "type": "rigid", "shape": {"box": {"size": [1, 0.1, 0.1]}}, "mass": 1, "position": [0.5, 0, 0],
       "rotation": {"axis": [0, 0, 1], "angle_deg": 0}},
      {"name": "box", "type": "rigid", "shape": {"box": {"size": [0.3, 0.3, 0.3]}}, "mass": 1, "position": [1, 0, 0]},
      {"name": "wall", "type": "static", "shape": {"box": {"size": [1, 1, 1]}}, "position": [-2, 0, 0]},
      {"name": "jelly", "type": "deformable", "shape": {"bar": {"size": [1, 1, 1], "cells": [1, 1, 1]}}, "mass": 1,
       "young": 1e5, "poisson": 0.3, "position": [0, 5, 0]},
      {"name": "drum", "type": "static", "shape": {"box": {"size": [1, 1, 1]}}, "position": [0, -5, 0],
       "motion": {"angular_velocity": [0, 1, 0]}}],
     "joints": [)" +
           joints + "]}";
}

Scene read(const std::string& joints) { return read_scene(scene_with(joints), "", "m.json", {{"/nowhere"}}); }

std::string complaint(const std::string& joints)
{
    return complaint_of([&] { read(joints); });
}

const std::string hinge =
    R"({"name": "elbow", "type": "hinge", "a": "box", "b": "arm", "at": [1, 0, 0], "axis": [0, 0, 2]})";

}  // namespace

TEST_CASE("joint reader: every entry of a joint arrives")
{
    const Scene scene = read(R"({"name": "elbow", "type": "hinge", "a": "box", "b": "arm", "at": [1, 0, 0],
      "axis": [0, 0, 2], "limits_deg": [-90, 180], "motor": {"speed": -3, "most": 7},
      "spring": {"stiffness": 5, "damping": 2, "rest_deg": 90}, "breaks_at": 100, "touch": true})");
    REQUIRE(scene.world.joints.size() == 1);
    const Joint& joint = scene.world.joints[0];
    CHECK(joint.kind == JointKind::hinge);
    CHECK(joint.a.body == 1);
    CHECK(joint.b.body == 0);
    CHECK(joint.turn.low == doctest::Approx(-std::numbers::pi / 2));
    CHECK(joint.turn.high == doctest::Approx(std::numbers::pi));
    CHECK(joint.turn.motor_speed == -3);
    CHECK(joint.turn.motor_most == 7);
    CHECK(joint.turn.stiffness == 5);
    CHECK(joint.turn.damping == 2);
    CHECK(joint.turn.rest == doctest::Approx(std::numbers::pi / 2));
    CHECK(joint.breaks_at == 100);
    CHECK(joint.bodies_touch);
    const JointPose pose = committed_pose(scene.world, joint);
    CHECK((pose.point_a - Vec3(1, 0, 0)).norm() <= 1e-12);
    CHECK((pose.point_b - Vec3(1, 0, 0)).norm() <= 1e-12);
    CHECK((pose.axes_b.col(2) - Vec3::UnitZ()).norm() <= 1e-12);
    CHECK(scene.asks_joints == "m.json: /joints");
}

TEST_CASE("joint reader: a rod has its length, a rope at most its own, and a spring its own")
{
    const auto way = [](const std::string& more) {
        return read(R"({"name": "j", "a": "arm", "at": [1, 0, 0], "to": [1, 3, 0], "type": )" + more + "}")
            .world.joints.at(0)
            .way;
    };
    CHECK(way(R"("rod")").low == 3);
    CHECK(way(R"("rod")").high == 3);
    CHECK(way(R"("rope")").low == -std::numeric_limits<double>::infinity());
    CHECK(way(R"("rope")").high == 3);
    CHECK(way(R"("rope", "length": 4)").high == 4);
    CHECK(way(R"("spring", "stiffness": 9, "length": 2)").rest == 2);
    CHECK(way(R"("spring", "stiffness": 9)").high == std::numeric_limits<double>::infinity());
}

TEST_CASE("joint reader: a mistake is named with its place")
{
    CHECK(complaint(R"({"name": "j", "type": "ball", "a": "leg", "at": [0, 0, 0]})") ==
          "m.json: /joints/0/a: there is no body \"leg\"");
    CHECK(
        complaint(R"({"name": "j", "type": "ball", "a": "wall", "at": [0, 0, 0]})") ==
        "m.json: /joints/0/a: stands or moves as given; \"a\" is the one that forces move, and the other one is "
        "\"b\"");
    CHECK(complaint(R"({"name": "j", "type": "ball", "a": "arm", "b": "arm", "at": [0, 0, 0]})") ==
          "m.json: /joints/0/b: is \"a\" itself");
    CHECK(
        complaint(R"({"name": "j", "type": "hinge", "a": "jelly", "at": [0, 5, 0], "axis": [1, 0, 0]})") ==
        "m.json: /joints/0/a: \"jelly\" is soft, and a point of it has no axes that could be locked; a soft body "
        "takes the types \"ball\", \"rod\", \"rope\" and \"spring\"");
    CHECK(complaint(R"({"name": "j", "type": "ball", "a": "jelly", "at": [0, 6, 0]})") ==
          "m.json: /joints/0/at: is 0.5 m from the surface of \"jelly\", which it would hold");
    CHECK(complaint(hinge + "," + hinge) ==
          "m.json: /joints/1/name: another joint is already called \"elbow\"");
    CHECK(complaint(R"({"name": "j", "type": "rod", "a": "arm", "at": [1, 0, 0], "to": [1, 0, 0]})") ==
          "m.json: /joints/0/to: is the point \"at\"; between them is no direction");
    CHECK(
        complaint(
            R"({"name": "j", "type": "rope", "a": "arm", "at": [1, 0, 0], "to": [1, 2, 0], "length": 1})") ==
        "m.json: /joints/0/length: is shorter than the 2 m from \"at\" to \"to\"");
    CHECK(complaint(R"({"name": "j", "type": "slider", "a": "arm", "at": [0, 0, 0], "axis": [1, 0, 0],
                        "limits": [1, 2]})") ==
          "m.json: /joints/0/limits: the joint begins at 0, which lies outside of its limits");
    CHECK(complaint(R"({"name": "j", "type": "universal", "a": "arm", "at": [0, 0, 0], "axis": [1, 0, 0],
                        "axis_b": [1, 1, 0]})") ==
          "m.json: /joints/0/axis_b: is not at right angles to \"axis\"");
    CHECK(complaint(R"({"name": "j", "type": "ball", "a": "arm", "at": [0, 0, 0], "axis": [1, 0, 0]})") !=
          "");
}

TEST_CASE("joint reader: a soft body is held at the nearest point of its surface, a driven one where it is")
{
    const Scene scene = read(R"({"name": "j", "type": "ball", "a": "jelly", "at": [0.1, 5.52, 0.2]},
      {"name": "k", "type": "ball", "a": "arm", "b": "drum", "at": [1, 0, 0]})");
    const Joint& soft = scene.world.joints[0];
    REQUIRE(soft.a.is_soft());
    const JointPose pose = committed_pose(scene.world, soft);
    CHECK((pose.point_a - Vec3(0.1, 5.5, 0.2)).norm() <= 1e-12);
    CHECK((pose.point_b - pose.point_a).norm() <= 1e-12);
    CHECK(soft.a.weights.sum() == doctest::Approx(1));
    const JointPose driven = committed_pose(scene.world, scene.world.joints[1]);
    CHECK((driven.point_b - Vec3(1, 0, 0)).norm() <= 1e-12);
}

TEST_CASE("joint reader: a gear, a motor's target and a bouncing limit arrive, and their mistakes are named")
{
    const std::string two =
        R"({"name": "one", "type": "hinge", "a": "arm", "at": [0, 0, 0], "axis": [0, 0, 1],
        "limits_deg": [-90, 90], "restitution": 0.4, "motor": {"to_deg": 45, "most": 3}},
      {"name": "two", "type": "hinge", "a": "box", "at": [1, 0, 0], "axis": [0, 0, 1]},)";
    const auto gear = [](const std::string& hinges, const std::string& ratio) {
        return R"({"name": "gear", "type": "gear", "hinges": )" + hinges + R"(, "ratio": )" + ratio + "}";
    };
    const Scene scene = read(two + gear(R"(["one", "two"])", "-2"));
    const Joint &hinge = scene.world.joints[0], &last = scene.world.joints[2];
    CHECK(hinge.turn.bounce == 0.4);
    CHECK(*hinge.turn.motor_target == doctest::Approx(std::numbers::pi / 4));
    CHECK(hinge.turn.motor_speed == std::numeric_limits<double>::infinity());
    CHECK(last.kind == JointKind::gear);
    CHECK(last.hinges == std::array<int, 2>{0, 1});
    CHECK(last.ratio == -2);
    CHECK(complaint(two + gear(R"(["one", "three"])", "1")) ==
          "m.json: /joints/2/hinges/1: there is no joint \"three\" before this one");
    CHECK(complaint(two + gear(R"(["one", "one"])", "1")) ==
          "m.json: /joints/2/hinges/1: is the first one itself");
    CHECK(complaint(two + gear(R"(["one", "two"])", "0")) ==
          "m.json: /joints/2/ratio: is 0; a gear turns both");
    CHECK(complaint(R"({"name": "j", "type": "ball", "a": "arm", "at": [0, 0, 0]},)" +
                    gear(R"(["j", "j"])", "1")) ==
          "m.json: /joints/1/hinges/0: \"j\" is no hinge, and a gear joins two of them");
    CHECK(
        complaint(
            R"({"name": "j", "type": "hinge", "a": "arm", "b": "drum", "at": [0, 0, 0], "axis": [0, 0, 1]},)" +
            gear(R"(["j", "j"])", "1")) ==
        "m.json: /joints/1/hinges/0: \"j\" stands on \"drum\", which moves as given; a gear's hinges stand on the "
        "world or on rigid bodies");
    CHECK(complaint(R"({"name": "j", "type": "hinge", "a": "arm", "at": [0, 0, 0], "axis": [0, 0, 1],
                        "restitution": 0.5})") ==
          "m.json: /joints/0/restitution: stands without limits, at which alone a joint bounces");
}

TEST_CASE("joint reader: a solver without joints refuses the scene, with the place")
{
    Solver without, with;
    without.name = "chapter 10";
    with.has_joints = true;
    CHECK_NOTHROW(require_asked(read(hinge), with));
    CHECK_NOTHROW(require_asked(read(""), without));
    CHECK_THROWS_WITH_AS(
        require_asked(read(hinge), without),
        "m.json: /joints: chapter 10 has no joints; choose the solver of chapter 12, or leave the key out",
        InputError);
}

TEST_CASE("joint reader: bodies that a joint holds together are not warned of where they overlap")
{
    CHECK(read(hinge).warnings.empty());
    CHECK(read("").warnings.size() == 1);
}
