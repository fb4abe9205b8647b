#include "common/geometry/tests/complaint.hpp"
#include "common/scenes/scene_reader.hpp"
#include "common/simulation/rigid_body.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace enduring;

namespace {

/// A scene with what is given for all pairs, of the second of two materials, of a plane, and of a body.
struct Given {
    std::string friction, material, plane, body;
    std::string type = R"("type": "rigid", "shape": {"box": {"size": [1, 1, 1]}}, "mass": 1)";
};

Scene read(const Given& given)
{
    return read_scene(
        R"({"name": "s", "dt": 0.1, "duration": 1,
      "contact": {"friction": {"model": "none")" +
            given.friction +
            R"(}}, "materials": [{"name": "one", "mu_s": 0.5}, {"name": "two", "mu_s": 0.5)" +
            given.material + R"(}], "planes": [{"name": "p")" + given.plane +
            R"(}], "bodies": [{"name": "b", "rotation": {"axis": [0, 0, 1], "angle_deg": 90}, )" +
            given.type + given.body + "}]}",
        "", "s.json", {});
}

std::string complaint(const Given& given)
{
    return complaint_of([&] { read(given); });
}

}  // namespace

TEST_CASE("scene: laws of a surface arrive for all pairs, and of two materials the larger number counts")
{
    const Scene all = read({R"(, "viscous": 0.1, "rolling": 0.2, "patch": 0.3)", "", "", ""});
    CHECK(all.contact.surface_laws.viscous == 0.1);
    CHECK(all.contact.surface_laws.rolling == 0.2);
    CHECK(all.contact.surface_laws.patch == 0.3);
    const Scene two = read({"", R"(, "rolling": 0.2)", "", ""});
    CHECK(two.world.friction.of(0, 0).laws.rolling == 0);
    CHECK(two.world.friction.of(0, 1).laws.rolling == 0.2);
    CHECK(two.world.friction.of(1, 1).laws.rolling == 0.2);
    CHECK(two.asks_surface_laws == "s.json: /materials");
    CHECK(read({}).asks_surface_laws.empty());
}

TEST_CASE("scene: a grain of a body turns with its shape, and that of a plane lies in the world")
{
    const std::string grain = R"(, "grain": {"along": [2, 0, 0], "across": 0.4})";
    const Scene scene = read({"", "", grain, grain});
    CHECK((scene.world.planes[0].grain.direction - Vec3::UnitX()).norm() <= 1e-12);
    CHECK(scene.world.planes[0].grain.across == 0.4);
    const Body& body = *scene.world.bodies[0];
    const auto& rigid = dynamic_cast<const RigidBody&>(body);
    const Vec3 in_world = rigid.motion().pose().orientation * body.grain().direction;
    CHECK((in_world - Vec3::UnitY()).norm() <= 1e-12);
    CHECK(scene.asks_surface_laws == "s.json: /planes");
}

TEST_CASE(
    "scene: mistakes in laws of a surface are named with their place, and a solver without them refuses")
{
    CHECK(complaint({R"(, "rolling": -1)", "", "", ""}) ==
          "s.json: /contact/friction/rolling: expected a number from 0 to 1000 [m], found -1");
    CHECK(complaint({"", "", R"(, "grain": {"along": [0, 0, 0], "across": 1})", ""}) != "");
    CHECK(complaint({"", "", R"(, "grain": {"along": [1, 0, 0], "across": 0})", ""}) != "");
    Given soft{"", "", "", R"(, "grain": {"along": [1, 0, 0], "across": 1})"};
    soft.type = R"("type": "deformable", "shape": {"bar": {"size": [1, 1, 1], "cells": [1, 1, 1]}}, "mass": 1,
        "young": 1e5, "poisson": 0.3)";
    CHECK(
        complaint(soft) ==
        "s.json: /bodies/0/grain: a soft body's parts turn against each other, so it has no direction of a grain");
    Solver without, with;
    without.name = "chapter 6";
    with.has_surface_laws = true;
    const Scene scene = read({R"(, "patch": 0.3)", "", "", ""});
    CHECK_NOTHROW(require_asked(scene, with));
    CHECK(complaint_of([&] {
              require_asked(scene, without);
          }).starts_with("s.json: /contact/friction: chapter 6 knows no \"viscous\""));
}
