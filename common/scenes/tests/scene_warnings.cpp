#include "common/experiments/report/tests/temporary_folder.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/scenes/scene_reader.hpp"
#include "common/scenes/start_overlap.hpp"
#include "common/scenes/stiffness_check.hpp"
#include "common/simulation/deformable_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

using namespace enduring;

namespace {

Scene read(const std::string& rest)
{
    return read_scene(R"({"name": "trial", "dt": 0.01, "duration": 1, )" + rest + "}", "", "trial.json", {});
}

std::string body(const std::string& name, const std::string& type, const std::string& shape,
                 const std::string& place, const std::string& more = "")
{
    return R"({"name": ")" + name + R"(", "type": ")" + type + R"(", "shape": )" + shape +
           R"(, "position": )" + place + more + "}";
}

std::string cube(const std::string& name, const std::string& place,
                 const std::string& more = R"(, "mass": 10)")
{
    return body(name, "rigid", R"({"box": {"size": [1, 1, 1]}})", place, more);
}

std::vector<StartOverlap> overlaps(const std::string& rest)
{
    const Scene scene = read(rest);
    return start_overlaps(scene.world, scene.contact);
}

const std::string soft = R"(, "mass": 10, "young": 1e5, "poisson": 0.3)";

}  // namespace

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
