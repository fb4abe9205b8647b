#include "common/input/input_error.hpp"
#include "common/scenes/scene.hpp"
#include "common/scenes/tests/small_scenes.hpp"

#include <doctest/doctest.h>

#include <fstream>

using namespace enduring;
using namespace enduring::tests;

TEST_CASE("scene: numbers out of range are named with their path, range, unit and value")
{
    CHECK(complaint(R"({"dt": 0})") == "ball.json: /dt: expected a number from 1e-06 to 3600 [s], found 0");
    CHECK(complaint(R"({"dt": 3601})") ==
          "ball.json: /dt: expected a number from 1e-06 to 3600 [s], found 3601");
    CHECK(complaint(R"({"duration": -1})") ==
          "ball.json: /duration: expected a number above 0 up to 3600 [s], found -1");
    CHECK(complaint(R"({"contact": {"stiffness": 0}})") ==
          "ball.json: /contact/stiffness: expected a number above 0 up to 1e+12 [N/m], found 0");
    CHECK(
        complaint(R"({"contact": {"max_depenetration_velocity": 0}})") ==
        "ball.json: /contact/max_depenetration_velocity: expected a number above 0 up to 10 [m/s], found 0");
    CHECK(
        complaint(R"({"contact": {"max_depenetration_velocity": 11}})") ==
        "ball.json: /contact/max_depenetration_velocity: expected a number above 0 up to 10 [m/s], found 11");
    CHECK(complaint(R"({"contact": {"wanted_depth": 0}})") ==
          "ball.json: /contact/wanted_depth: expected a number above 0 up to 1 [m], found 0");
    CHECK(complaint(R"({"contact": {"wanted_depth": 1.5}})") ==
          "ball.json: /contact/wanted_depth: expected a number above 0 up to 1 [m], found 1.5");
    CHECK(complaint(R"({"/planes/ground/stiffness": 0})") ==
          "ball.json: /planes/0/stiffness: expected a number above 0 up to 1e+12 [N/m], found 0");
    CHECK(complaint(R"({"/bodies/0/mass": -3})") ==
          "ball.json: /bodies/0/mass: expected a number from 1e-09 to 1e+09 [kg], found -3");
    CHECK(complaint(R"({"/bodies/0": {"mass": null, "density": -3}})") ==
          "ball.json: /bodies/0/density: expected a number from 0.001 to 1e+06 [kg/m^3], found -3");
    CHECK(complaint(R"({"/bodies/0/shape/sphere/radius": 0})") ==
          "ball.json: /bodies/0/shape/sphere/radius: expected a number above 0 up to 10000 [m], found 0");
    CHECK(complaint(R"({"/bodies/1/shape/plane_grid/cells": [0, 1]})") ==
          "ball.json: /bodies/1/shape/plane_grid/cells/0: expected a whole number from 1 to 2000, found 0");
    CHECK(complaint(R"({"gravity": [0, 1e9, 0]})") ==
          "ball.json: /gravity/1: expected a number from -1000 to 1000 [m/s^2], found 1000000000.0");
}

TEST_CASE("scene: wrong types are named with what was expected")
{
    CHECK(complaint(R"({"dt": "0.1"})") ==
          "ball.json: /dt: expected a number from 1e-06 to 3600 [s], found \"0.1\"");
    CHECK(complaint(R"({"bodies": {}})") ==
          "ball.json: /bodies: expected a list of 1 to 100000 entries, found the object {}");
    CHECK(complaint(R"({"bodies": []})") ==
          "ball.json: /bodies: expected a list of 1 to 100000 entries, found the list []");
    CHECK(complaint(R"({"gravity": [0, 1]})") ==
          "ball.json: /gravity: expected a list of three numbers, found the list [0,1]");
    CHECK(complaint(R"({"contact": {"method": "cpg"}})") ==
          "ball.json: /contact/method: expected one of \"dpf\", \"cpf\", found \"cpg\"");
    CHECK(
        complaint(R"({"contact": 5})") ==
        "ball.json: /contact: expected an object with the keys \"method\", \"stiffness\", \"friction\", \"max_depenetration_velocity\", \"wanted_depth\", \"restitution\", \"exact\", found 5");
    CHECK(complaint(R"({"/bodies/0/look/smooth": 1})") ==
          "ball.json: /bodies/0/look/smooth: expected true or false, found 1");
    CHECK(complaint(R"({"/bodies/0/type": 7})") ==
          "ball.json: /bodies/0/type: expected one of \"static\", \"rigid\", \"deformable\", found 7");
    CHECK(complaint(R"({"/bodies/1/shape/plane_grid/cells": [1.5, 1]})") ==
          "ball.json: /bodies/1/shape/plane_grid/cells/0: expected a whole number from 1 to 2000, found 1.5");
    CHECK(complaint(R"({"name": ""})") ==
          "ball.json: /name: expected a text in quotes that is not empty, found \"\"");
}

TEST_CASE("scene: unknown and missing keys are named, and a near miss is guessed")
{
    CHECK(complaint(R"({"contact": {"stifness": 5}})") ==
          "ball.json: /contact/stifness: unknown key; did you mean \"stiffness\"?");
    CHECK(complaint(R"({"camera": {"zebra": 5}})") ==
          "ball.json: /camera/zebra: unknown key; allowed here: \"eye\", \"target\", \"field_of_view_deg\"");
    CHECK(
        complaint(R"({"/bodies/1/density": 5})") ==
        "ball.json: /bodies/1/density: unknown key; allowed here: \"name\", \"type\", "
        "\"shape\", \"shapes\", \"position\", \"rotation\", \"look\", \"material\", \"motion\", \"surface_velocity\", "
        "\"sheet\", \"grain\"");
    CHECK(complaint(R"({"a/b": 5})").find("ball.json: /a~1b: unknown key") == 0);
    CHECK(complaint(R"({"dt": null})") == "ball.json: /: the key \"dt\" is missing");
    CHECK(complaint(R"({"/bodies/0": {"name": null}})") ==
          "ball.json: /bodies/0: the key \"name\" is missing");
    CHECK(complaint(R"({"/bodies/0": {"mass": null}})") ==
          "ball.json: /bodies/0: one of the keys \"density\" and \"mass\" is missing");
    CHECK(complaint(R"({"/bodies/0": {"density": 5}})") ==
          "ball.json: /bodies/0/mass: stands beside \"density\"; one of the two is enough");
    CHECK(complaint(R"({"/bodies/1/name": "ball"})") ==
          "ball.json: /bodies/1/name: another body or plane is already called \"ball\"");
    CHECK(complaint(R"({"/bodies/1/name": "ground"})") ==
          "ball.json: /bodies/1/name: another body or plane is already called \"ground\"");
}

TEST_CASE("scene: several mistakes are told at once, one a line")
{
    const std::string all =
        complaint(R"({"dt": -1, "contact": {"stiffness": 0, "method": "xpf"}, "/bodies/0/mass": -2,
                                          "/bodies/1/position": "here", "camera": {"eye": 3}})");
    for (const char* place : {"/dt: ", "/contact/method: ", "/contact/stiffness: ", "/bodies/0/mass: ",
                              "/bodies/1/position: ", "/camera/eye: "})
        CHECK_MESSAGE(all.find(std::string("ball.json: ") + place) != std::string::npos, place,
                      " is not in:\n", all);
    CHECK(std::count(all.begin(), all.end(), '\n') == 5);
    CHECK(complaint(R"({"/bodies/0": 7})") == "ball.json: /bodies/0: expected an object, found 7");
}

TEST_CASE("scene: shapes that cannot be are refused")
{
    CHECK(complaint(R"({"/bodies/0/shape": {"box": {"size": [1, 1, 1]}}})")
              .find("ball.json: /bodies/0/shape: expected an object with exactly one of") == 0);
    CHECK(complaint(R"({"/bodies/0/shape": {"sphere": null, "file": "bunny_7.msh"}})") ==
          "ball.json: /bodies/0/shape/file: there is no mesh file \"bunny_7.msh\" (searched in /nowhere)");
    CHECK(
        complaint(
            R"({"/bodies/0/shape": {"sphere": null, "bowl": {"inner_radius": 1, "thickness": 0.1, "foot_radius": 50}}})")
            .find("ball.json: /bodies/0/shape/bowl: foot_radius") == 0);
    CHECK(
        complaint(
            R"({"/bodies/0/shape": {"sphere": null, "box": {"size": [1, 1, 1], "cells": [2000, 2000, 2000]}}})") ==
        "ball.json: /bodies/0/shape/box: asks for 48000000 faces; at most 1000000 are allowed");
    CHECK(complaint(R"({"/bodies/0/shape": {"sphere": null, "plane_grid": {"size": [1, 1]}}})")
              .find("ball.json: /bodies/0/shape: ") == 0);
    CHECK(
        complaint(R"({"planes": [{"name": "p", "normal": [0, 0, 0]}]})") ==
        "ball.json: /planes/0/normal: expected three numbers that are not all zero, found the list [0,0,0]");
    CHECK(complaint(R"({"camera": {"eye": [0, 1, 0]}})") ==
          "ball.json: /camera: \"eye\" and \"target\" are the same point");
}

TEST_CASE("scene: a syntax error is named with its line, and a key that stands twice is one")
{
    const auto message = [](const std::string& text) {
        return complaint_of([&] { read_scene(text, "", "s.json", {}); });
    };
    CHECK(message("{\n \"dt\": 0.1,\n}").find("s.json: not valid JSON: parse error at line 3, column 1") ==
          0);
    CHECK(message("").find("s.json: not valid JSON") == 0);
    CHECK(message("{\"dt\": 0.1, \"dt\": 0.2}") ==
          "s.json:1: the key \"dt\" stands twice in the same object");
    CHECK(message("{\"name\": \"a\", \"dt\": 0.1, \"duration\": 1, \"contact\": {\"name\": 1}}")
              .find("s.json: /contact/name: unknown key") == 0);
    CHECK(message(std::string(5000, '[')).find("s.json:1: lists and objects are nested more than 32 deep") ==
          0);
    CHECK(message("{\"dt\": 0.1,\n\n \"name\": {\"a\": 1,\n \"a\": 2}}") ==
          "s.json:4: the key \"a\" stands twice in the same object");
    CHECK(message("{\n\"dt\": 1e999}").find("s.json:2: number overflow parsing '1e999'") == 0);
    CHECK(message("{\n\"dt\": " + std::string(3'000'000, '7') + "}").size() < 250);
    CHECK(message("{\"dt\":\n" + std::string(40, '[')).find("s.json:2: lists and objects are nested") == 0);
    CHECK(message("\"\xff\"").find("s.json: not valid JSON") == 0);
    CHECK(message("7").find("s.json: /: expected an object with the keys") == 0);
}

TEST_CASE(
    "scene: a key of a million letters is cut in the message, and a byte that is zero ends no file early")
{
    const auto message = [](const std::string& text) {
        return complaint_of([&] { read_scene(text, "", "s.json", {}); });
    };
    const std::string key = '"' + std::string(1'000'000, 'x') + "\": 1";
    CHECK(message('{' + key + '}').find("...: unknown key") < 200);
    CHECK(message('{' + key + ", " + key + '}').size() < 300);
    CHECK(message("{\"dt\": 0.1}\n" + std::string(1, '\0') + "}") ==
          "s.json:2: a byte that is zero; only text can be read");
}

TEST_CASE("scene: a file that is missing, a folder or empty is named")
{
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "enduring_scene_test";
    std::filesystem::create_directories(folder);
    CHECK_THROWS_WITH_AS(load_scene(folder / "none.json"), (folder / "none.json: no such file").c_str(),
                         InputError);
    CHECK_THROWS_AS(load_scene(folder), InputError);
    std::ofstream(folder / "empty.json").close();
    CHECK_THROWS_WITH_AS(load_scene(folder / "empty.json"), doctest::Contains("empty"), InputError);
    std::filesystem::remove_all(folder);
}
