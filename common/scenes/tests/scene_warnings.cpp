#include "common/experiments/report/tests/temporary_folder.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/scenes/stiffness_check.hpp"
#include "common/scenes/tests/trial_scene.hpp"
#include "common/simulation/deformable_body.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

using namespace enduring;
using namespace enduring::tests;

TEST_CASE("scene: warnings name the file, the bodies and the numbers, and a scene that is well has none")
{
    const std::string ground = R"("planes": [{"name": "ground"}], "bodies": [)";
    CHECK(read(R"("contact": {"stiffness": 5000}, )" + ground + cube("cube", "[0, 0.5, 0]") + "]")
              .warnings.empty());
    CHECK(
        read(R"("bodies": [)" + cube("lower", "[0, 0.5, 0]") + ", " + cube("upper", "[0.2, 1.25, 0.1]") + "]")
            .warnings ==
        std::vector<std::string>{
            "trial.json: 'upper' begins inside 'lower', 0.25 m deep: a solver that traces intersections separates them at 0.345 m/s "
            "(/contact/max_depenetration_velocity), one that waits for surfaces to cross lets it fall through"});
    CHECK(
        read(R"("contact": {"max_depenetration_velocity": 0.1}, )" + ground + cube("cube", "[0, 0.2, 0]") +
             "]")
            .warnings ==
        std::vector<std::string>{
            "trial.json: 'cube' begins inside 'ground', 0.3 m deep: a solver that traces "
            "intersections separates them at 0.1 m/s (/contact/max_depenetration_velocity), one that does not "
            "throws it out, since all weight of the scene would not press it so far"});
    const std::string sheet = body("floor", "static", R"({"plane_grid": {"size": [6, 6], "cells": [2, 2]}})",
                                   "[0, 0, 0]");
    CHECK(
        read(R"("bodies": [)" + sheet + ", " + cube("cube", "[0.1, 0.47, 0.2]") + "]").warnings ==
        std::vector<std::string>{
            "trial.json: 'cube' begins inside 'floor', 0.03 m deep: a surface with a border has no inside to separate "
            "from, nor have points and edges, so the body falls through; move one of them"});
}

TEST_CASE(
    "scene: a body that begins behind the walls of a room is told, and one that begins in its air is not")
{
    const TemporaryFolder folder;
    const SurfaceMesh cube_mesh = box({4, 4, 4});
    const auto write = [&](const std::string& name, bool inwards) {
        std::ofstream file(folder.path / name);
        for (const Vec3& v : cube_mesh.vertices)
            file << "v " << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
        for (const auto& [a, b, c] : cube_mesh.faces)
            file << "f " << a + 1 << ' ' << (inwards ? c : b) + 1 << ' ' << (inwards ? b : c) + 1 << '\n';
    };
    write("room.obj", true);
    write("solid.obj", false);
    const auto told = [&](const std::string& bodies) {
        SceneSurroundings surroundings;
        surroundings.mesh_folders.push_back(folder.path);
        return read_scene(R"({"name": "trial", "dt": 0.01, "duration": 1, "bodies": [)" + bodies + "]}", "",
                          "trial.json", surroundings)
            .warnings;
    };
    const std::string room = body("room", "static", R"({"file": "room.obj"})", "[0, 0, 0]") + ", ",
                      solid = body("solid", "static", R"({"file": "solid.obj"})", "[0, 0, 0]") + ", ";
    CHECK(told(room + cube("cube", "[0, 0, 0]")).empty());
    CHECK(told(room + cube("cube", "[1.5, -1.5, 0.3]")).empty());  // in touch with two walls
    CHECK(told(solid + cube("cube", "[0, 3, 0]")).empty());
    const auto beyond = told(room + cube("cube", "[0, 3, 0]"));
    REQUIRE(beyond.size() == 1);
    CHECK(
        beyond[0] ==
        "trial.json: 'cube' begins behind the walls of 'room', 1.5 m deep: the faces of 'room' look inwards, so "
        "it is a room, which holds only what begins in it; turn its faces around if it is a solid, or move "
        "'cube' into it");
    const auto partly = told(room + cube("cube", "[1.6, 0.7, 0.3]"));
    REQUIRE(partly.size() == 1);
    CHECK(partly[0].find("'cube' begins partly behind the walls of 'room', 0.1 m deep: ") !=
          std::string::npos);
    CHECK(told(room + cube("cube", "[1.6, 0, 0]")).size() == 1);  // a middle of the wall's edges is in it
    const std::string next_door = body("next", "static", R"({"file": "room.obj"})", "[5, 0, 0]") + ", ";
    CHECK(told(room + next_door + cube("one", "[0, 0, 0]") + ", " + cube("two", "[5, 0, 0]")).empty());
    CHECK(told(room + next_door + cube("one", "[2.5, 0, 0]")).size() == 1);
}

TEST_CASE("scene: a soft body that its own weight presses flat is told, and no other")
{
    const auto warned = [](const std::string& young, const std::string& more) {
        return read(
                   R"("bodies": [{"name": "jelly", "type": "deformable", "shape": {"bar": {"size": [0.2, 0.2, 0.2]}},
            "density": 1000, "poisson": 0.3, "young": )" +
                   young + more + "}]")
            .warnings;
    };
    CHECK(warned("2000", "").empty());  // 1000 * 9.81 * 0.2 is a little less
    CHECK(warned("0.2", R"(, "gravity": false)").empty());
    CHECK(
        warned("0.2", "") ==
        std::vector<std::string>{
            "trial.json: 'jelly' is so soft that its own weight presses it flat (density * gravity * size / young = 9810); "
            "is \"young\" in pascal?"});
}

TEST_CASE("scene: linear elements whose volume hardly changes are told to bend too little, and no others")
{
    const auto warnings_of = [](const std::string& poisson, const std::string& basis) {
        return read(R"("bodies": [)" +
                    body("jelly", "deformable", R"({"bar": {"size": [1, 1, 1]}})", "[0, 0, 0]",
                         R"(, "mass": 10, "young": 1e5, "poisson": )" + poisson + basis) +
                    "]")
            .warnings;
    };
    const std::string linear = R"(, "basis": "linear")";
    for (const std::string poisson : {"0.3", "0.4"})
        CHECK(warnings_of(poisson, linear).empty());
    CHECK(warnings_of("0.45", "").empty());
    const std::vector<std::string> told = warnings_of("0.45", linear);
    REQUIRE(told.size() == 1);
    CHECK(
        told[0] ==
        "trial.json: 'jelly' has linear elements and a Poisson's ratio of 0.45, with which they bend several "
        "times too little; give it \"basis\": \"quadratic\"");
}

TEST_CASE("scene: a soft body that is held at every node bears any step")
{
    const auto told = [](const std::string& fixed) {
        return read(
                   R"("planes": [{"name": "ground"}], "contact": {"stiffness": 1e9}, "bodies": [{"name": "jelly",
            "type": "deformable", "shape": {"bar": {"size": [1, 1, 1]}}, "density": 1000, "poisson": 0.3, "young": 1e6,
            "position": [0, 1, 0], "fixed": )" +
                   fixed + "}]")
            .stiffness_warning;
    };
    CHECK(!told(R"({"until": 0.5})"));
    CHECK(told(R"({"min": [0.4, -1, -1]})"));
}

TEST_CASE("scene: who is too stiff is named by the key that the file has, or by the default")
{
    const auto told = [](const std::string& contact, const std::string& plane, double mass) {
        return read(contact + R"("planes": [{"name": "ground")" + plane + R"(}], "bodies": [)" +
                    body("cube", "rigid", R"({"box": {"size": [1, 1, 1]}})", "[0, 0.5, 0]",
                         R"(, "mass": )" + std::to_string(mass)) +
                    "]")
            .stiffness_warning.value_or("nothing");
    };
    const std::string rest = "too stiff for the step where 'cube' meets 'ground': even on 4 pairs (n k = ",
                      advice =
                          " s, and dt is 0.01 s; make dt shorter, the stiffness smaller, or the bodies "
                          "heavier";
    CHECK(told(R"("contact": {"stiffness": 60000}, )", "", 10) ==
          "trial.json: /contact/stiffness: " + rest + "240000 N/m, on 10 kg) steps are stable up to 0.00913" +
              advice);
    const std::string by_default =
        "trial.json: /contact gives no \"stiffness\", and the default of 1000 N/m is " + rest +
        "4000 N/m, on 0.1 kg) steps are stable up to 0.00707" + advice;
    CHECK(told("", "", 0.1) == by_default);
    CHECK(told(R"("contact": {"friction": {"model": "none"}}, )", "", 0.1) == by_default);
    CHECK(told("", R"(, "stiffness": 2000)", 0.1) == "trial.json: /planes/ground/stiffness: " + rest +
                                                         "8000 N/m, on 0.1 kg) steps are stable up to 0.005" +
                                                         advice);
    CHECK(told("", R"(, "stiffness": 200)", 0.1) == "nothing");
    CHECK(told(R"("contact": {"stiffness": 5000}, )", "", 10) == "nothing");
}

TEST_CASE("scene: of the course's own scenes only the one that begins inside is warned of")
{
    int scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(scene_file("ground").parent_path()))
        if (entry.path().extension() == ".json") {
            CAPTURE(entry.path().string());
            const Scene scene = load_scene(entry.path());
            CHECK(scene.warnings.empty() == (entry.path().stem() != "initial_overlap"));
            CHECK_FALSE(scene.stiffness_warning.has_value());
            ++scenes;
        }
    CHECK(scenes > 15);
}

TEST_CASE(
    "overlap: a soft body that crosses itself is told, one that does not meet itself or is beside itself is not")
{
    const auto two_bars = [](const Vec3& apart, bool self_contact) {
        TetrahedralMesh mesh = bar(Vec3(1, 0.1, 0.1), {10, 1, 1});
        const auto first = mesh;
        const int count = static_cast<int>(mesh.nodes.size());
        for (const Vec3& node : first.nodes)
            mesh.nodes.push_back(Vec3(node.z(), node.y(), -node.x()) + apart);
        for (const auto& [a, b, c, d] : first.elements)
            mesh.elements.push_back({a + count, b + count, c + count, d + count});
        DeformableSettings settings;
        settings.self_contact = self_contact;
        World world;
        world.bodies.push_back(std::make_unique<DeformableBody>("bars", mesh, settings));
        return start_self_overlaps(world);
    };
    const auto crossed = two_bars(Vec3(0.02, 0.03, 0.01), true);
    REQUIRE(crossed.size() == 1);
    CHECK(crossed[0].body == "bars");
    CHECK(crossed[0].faces > 0);
    CHECK(two_bars(Vec3(0.02, 0.03, 0.01), false).empty());
    CHECK(two_bars(Vec3(0.02, 0.101, 0.01), true).empty());
}

TEST_CASE("scene: more than a thousand bodies and steps above a second are taken with a warning")
{
    std::string bodies;
    for (int i = 0; i < 1001; ++i) {
        const std::string number = std::to_string(i), place = std::to_string(3 * i);
        bodies.append(i == 0 ? "" : ", ");
        bodies.append(body(std::string("t").append(number), "static", R"({"tetrahedron": {"edge": 1}})",
                           std::string("[").append(place).append(", 0, 0]")));
    }
    const Scene many = read("\"bodies\": [" + bodies + "]");
    CHECK(many.world.bodies.size() == 1001);
    REQUIRE(many.warnings.size() == 1);
    CHECK(many.warnings[0].find(
              "trial.json: /bodies: 1001 of them, and the course measures scenes of up to 1000") == 0);
    const std::string one = R"(, "duration": 20, "bodies": [)" + cube("c", "[0, 0, 0]") + "]}";
    const Scene slow = read_scene(std::string(R"({"name": "slow", "dt": 2)").append(one), "", "slow.json",
                                  {});
    CHECK(slow.dt == 2);
    REQUIRE(slow.warnings.size() == 1);
    CHECK(slow.warnings[0].find(
              "slow.json: /dt: a step of 2 s is longer than any that the course measures") == 0);
    CHECK(slow.warnings[0].find("a body falls 39.2 m") != std::string::npos);
    CHECK(read_scene(std::string(R"({"name": "slow", "dt": 1)").append(one), "", "slow.json", {})
              .warnings.empty());
}

TEST_CASE("scene: a name that is not the file's is told")
{
    const TemporaryFolder folder;
    std::ofstream(folder.path / "one.json")
        << R"({"name": "other", "dt": 0.1, "duration": 1, "bodies": [)" << cube("c", "[0, 0, 0]") << "]}";
    const std::string file = (folder.path / "one.json").string();
    CHECK(load_scene(file).warnings ==
          std::vector<std::string>{
              file +
              ": /name: is \"other\", and the file is called \"one\"; results and pictures go by the file"});
    CHECK(load_scene(file, R"({"name": "one"})").warnings.empty());
}
