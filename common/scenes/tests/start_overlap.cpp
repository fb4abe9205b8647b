#include "common/scenes/stiffness_check.hpp"
#include "common/scenes/tests/trial_scene.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace enduring;
using namespace enduring::tests;

TEST_CASE(
    "overlap: two bodies that are inside each other at the start are named, with the depth of the deepest point")
{
    const std::string floor = body("floor", "static", R"({"box": {"size": [6, 1, 6], "cells": [4, 1, 4]}})",
                                   "[0, -0.5, 0]");
    for (const std::string& on :
         {cube("cube", "[0.1, 0.49, 0.2]"),
          cube("cube", "[0.1, 0.49, 0.2]",
               R"(, "mass": 10, "rotation": {"axis": [0, 1, 0], "angle_deg": 30})"),
          body("cube", "deformable", R"({"bar": {"size": [1, 1, 1], "cells": [2, 2, 2]}})",
               "[0.1, 0.49, 0.2]", soft)}) {
        const auto found = overlaps(R"("bodies": [)" + floor + ", " + on + "]");
        REQUIRE(found.size() == 1);
        CHECK(found[0].inner == "cube");
        CHECK(found[0].outer == "floor");
        CHECK(found[0].depth == doctest::Approx(0.01).epsilon(1e-9));
        CHECK_FALSE(found[0].whole);
    }
}

TEST_CASE(
    "overlap: boxes of one size that stand in each other have all corners on a surface, and are told all the same")
{
    const auto found = overlaps(R"("bodies": [)" + cube("lower", "[0, 0.5, 0]") + ", " +
                                cube("upper", "[0, 1.48, 0]") + "]");
    REQUIRE(found.size() == 1);
    CHECK(found[0].depth == doctest::Approx(0.02).epsilon(1e-9));
}

TEST_CASE("overlap: an open floor has no inside, but no body may stick through it")
{
    const std::string floor = body("floor", "static", R"({"plane_grid": {"size": [6, 6], "cells": [2, 2]}})",
                                   "[0, 0, 0]");
    const auto found = overlaps(R"("bodies": [)" + floor + ", " + cube("cube", "[0.1, 0.47, 0.2]") + "]");
    REQUIRE(found.size() == 1);
    CHECK(found[0].inner == "cube");
    CHECK(found[0].depth == doctest::Approx(0.03).epsilon(1e-9));
    CHECK(overlaps(R"("bodies": [)" + floor + ", " + cube("cube", "[0.1, -3, 0.2]") + "]")
              .empty());  // below it, and clear of it
}

TEST_CASE(
    "overlap: what touches does not overlap, to rounding, whichever way it is turned and however far out it lies")
{
    for (const std::string& far : {std::string("0"), std::string("9000")})
        for (const std::string& turn : {std::string("0"), std::string("30"), std::string("45")}) {
            CAPTURE(far);
            CAPTURE(turn);
            const std::string turned = R"(, "mass": 10, "rotation": {"axis": [0, 1, 0], "angle_deg": )" +
                                       turn + "}";
            CHECK(overlaps(R"("bodies": [)" + cube("lower", "[" + far + ", 0.5, 0]") + ", " +
                           cube("upper", "[" + far + ", 1.5, 0]", turned) + ", " +
                           cube("beside", "[" + far + ", 0.5, 1]") + "]")
                      .empty());
        }
    const std::string sloping = R"(, "mass": 10, "rotation": {"axis": [0, 0, 1], "angle_deg": 10})";
    const double s = std::sin(std::acos(-1) / 18), c = std::cos(std::acos(-1) / 18);
    // rounded to a millionth
    const std::string above = std::string("[") + std::to_string(-0.5 * s) + ", " + std::to_string(0.5 * c) +
                              ", 0]";
    for (const StartOverlap& overlap :
         overlaps(R"("bodies": [)" +
                  body("slope", "static", R"({"slope": {"size": [6, 1, 6], "angle_deg": 10}})", "[0, 0, 0]") +
                  ", " + cube("cube", above, sloping) + "]"))
        CHECK(overlap.depth < 1e-6);
}

TEST_CASE("overlap: a body that lies wholly inside another is told so, and two still ones are left alone")
{
    const auto found = overlaps(
        R"("bodies": [)" + cube("cube", "[0, 0, 0]") + ", " +
        body("pea", "rigid", R"({"sphere": {"radius": 0.1}})", "[0.1, 0.2, 0]", R"(, "mass": 1)") + "]");
    REQUIRE(found.size() == 1);
    CHECK(found[0].inner == "pea");
    CHECK(found[0].whole);
    CHECK(found[0].depth == doctest::Approx(0.4).epsilon(0.01));  // its lowest point, from the side
    const std::string box = R"({"box": {"size": [1, 1, 1]}})";
    CHECK(overlaps(R"("bodies": [)" + body("one", "static", box, "[0, 0, 0]") + ", " +
                   body("two", "static", box, "[0.3, 0.3, 0.3]") + "]")
              .empty());
}

TEST_CASE("overlap: a body may begin as deep in a plane as it rests, and no deeper")
{
    const auto at = [](const std::string& height) {
        return overlaps(R"("contact": {"stiffness": 2000}, "planes": [{"name": "ground"}], "bodies": [)" +
                        cube("cube", "[0, " + height + ", 0]") + "]");
    };
    CHECK(at("0.5").empty());
    CHECK(at("0.488").empty());  // 10 kg on four springs: 12.3 mm
    const auto deeper = at("0.45");
    REQUIRE(deeper.size() == 1);
    CHECK(deeper[0].in_plane);
    CHECK(deeper[0].depth == doctest::Approx(0.05));
    CHECK(at("-3").at(0).whole);
}

TEST_CASE(
    "stiffness check: a cube on the ground is chapter 1's particle on four springs, and the limit that of its method")
{
    for (const std::string method : {"cpf", "dpf"}) {
        const Scene scene = read(R"("contact": {"stiffness": 5000, "method": ")" + method +
                                 R"("}, "planes": [{"name": "ground"}], "bodies": [)" +
                                 cube("cube", "[0, 1, 0]") + "]");
        const auto contact = stiffest_contact(scene.world, scene.contact);
        REQUIRE(contact.has_value());
        CHECK(contact->pairs == 4);
        CHECK(contact->stiffness == 20000);
        CHECK(contact->stable_step ==
              doctest::Approx(std::sqrt((method == "cpf" ? 2.0 : 4.0 / 3) * 10 / 20000)));
        CHECK(contact->b == "ground");
    }
}

TEST_CASE(
    "stiffness check: two moving bodies have their reduced mass, and the lighter of two contacts is named")
{
    const Scene scene = read(
        R"("contact": {"stiffness": 5000}, "bodies": [)" + cube("heavy", "[0, 1, 0]", R"(, "mass": 100)") +
        ", " + cube("light", "[0, 3, 0]", R"(, "mass": 2)") + ", " +
        body("ball", "rigid", R"({"sphere": {"radius": 0.4}})", "[0, 5, 0]", R"(, "mass": 1)") + "]");
    const auto contact = stiffest_contact(scene.world, scene.contact);
    REQUIRE(contact.has_value());
    CHECK(contact->a == "light");
    CHECK(contact->b == "ball");
    CHECK(contact->pairs == 3);
    CHECK(contact->mass == doctest::Approx(2.0 / 3));
    CHECK(contact->stable_step == doctest::Approx(std::sqrt(2 * (2.0 / 3) / 15000)));
}

TEST_CASE(
    "stiffness check: a soft body that answers lumped counts by its heaviest vertex, one that answers implicitly as a whole")
{
    const auto contact_of = [](const std::string& response) {
        const Scene scene =
            read(R"("contact": {"stiffness": 5000}, "planes": [{"name": "ground"}], "bodies": [)" +
                 body("bar", "deformable", R"({"bar": {"size": [2, 1, 1], "cells": [2, 1, 1]}})", "[0, 1, 0]",
                      soft + response) +
                 "]");
        return *stiffest_contact(scene.world, scene.contact);
    };
    const StiffestContact lumped = contact_of(""),
                          implicit = contact_of(R"(, "impulse_response": "implicit")");
    CHECK(implicit.mass == doctest::Approx(10));
    const Scene scene = read(
        R"("bodies": [)" +
        body("bar", "deformable", R"({"bar": {"size": [2, 1, 1], "cells": [2, 1, 1]}})", "[0, 1, 0]", soft) +
        "]");
    double heaviest = 0;
    for (int vertex = 0; vertex < scene.world.bodies[0]->surface().vertex_count(); ++vertex)
        heaviest = std::max(heaviest, 1 / scene.world.bodies[0]->inverse_mass(vertex)(0, 0));
    CHECK(lumped.stable_step == doctest::Approx(std::sqrt(2 * heaviest / 5000)));
    CHECK_FALSE(stiffest_contact(scene.world, scene.contact).has_value());  // nobody to meet
}

TEST_CASE("stiffness check: a box' side has as many corners as its cells give it, a sphere's three")
{
    const auto fewest = [](const std::string& shape) {
        const Scene scene = read(R"("bodies": [)" +
                                 body("it", "static", shape, "[0, 0, 0]",
                                      R"(, "rotation": {"axis": [1, 2, 3], "angle_deg": 40})") +
                                 "]");
        return corners_of_smallest_side(scene.world.bodies[0]->surface(),
                                        scene.world.bodies[0]->positions_t0());
    };
    CHECK(fewest(R"({"box": {"size": [1, 2, 3]}})") == 4);
    CHECK(fewest(R"({"box": {"size": [1, 2, 3], "cells": [1, 2, 3]}})") == 6);
    CHECK(fewest(R"({"sphere": {"radius": 1}})") == 3);
}
