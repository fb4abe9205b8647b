#include "common/scenes/scene.hpp"
#include "common/geometry/tests/complaint.hpp"
#include "common/input/input_error.hpp"
#include "common/scenes/scene_reader.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/step.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>

using namespace enduring;

namespace {

const std::string ball_text = R"({
  "name": "ball", "gravity": [0, -10, 0], "dt": 0.01, "duration": 0.5,
  "contact": {"method": "dpf", "stiffness": 500, "max_depenetration_velocity": 0.2, "wanted_depth": 1e-4},
  "planes": [{"name": "ground", "point": [0, -1, 0], "normal": [0, 2, 0], "stiffness": 9000}],
  "bodies": [
    {"name": "ball", "type": "rigid", "shape": {"sphere": {"radius": 0.5}}, "mass": 2,
     "position": [0, 3, 0], "velocity": [1, 0, 0], "look": {"color": [1, 0.5, 0], "smooth": true}},
    {"name": "floor", "type": "static", "shape": {"plane_grid": {"size": [4, 6], "cells": [2, 3]}}}
  ],
  "camera": {"eye": [1, 2, 3], "target": [0, 1, 0], "field_of_view_deg": 40}
})";

Scene ball(const std::string& patch = "")
{
    return read_scene(ball_text, patch, "ball.json", {{"/nowhere"}});
}

std::string complaint(const std::string& patch)
{
    return complaint_of([&] { ball(patch); });
}

}  // namespace

TEST_CASE("scene: every entry of the file arrives")
{
    const Scene scene = ball();
    CHECK(scene.name == "ball");
    CHECK(scene.dt == 0.01);
    CHECK(scene.duration == 0.5);
    CHECK(scene.contact.method == PenaltyMethod::discrete);
    CHECK(scene.contact.stiffness == 500);
    CHECK(scene.contact.max_depenetration_velocity == 0.2);
    CHECK(scene.contact.wanted_depth == 1e-4);
    CHECK(scene.gives_stiffness);
    CHECK(scene.world.gravity == Vec3(0, -10, 0));
    REQUIRE(scene.world.planes.size() == 1);
    CHECK(scene.world.planes[0].normal == Vec3(0, 1, 0));
    CHECK(scene.world.planes[0].point == Vec3(0, -1, 0));
    CHECK(scene.world.planes[0].stiffness == 9000.0);
    REQUIRE(scene.world.bodies.size() == 2);
    const Body& sphere = *scene.world.bodies[0];
    CHECK(sphere.mass() == doctest::Approx(2));
    CHECK((sphere.linear_momentum() - Vec3(2, 0, 0)).norm() < 1e-14);
    for (const Vec3& vertex : sphere.positions_t0())
        CHECK((vertex - Vec3(0, 3, 0)).norm() == doctest::Approx(0.5));
    CHECK(scene.world.bodies[1]->is_static());
    CHECK(scene.looks.at("ball").smooth);
    CHECK(scene.looks.at("ball").color == Vec3(1, 0.5, 0));
    CHECK(scene.camera.eye == Vec3(1, 2, 3));
    CHECK(scene.camera.field_of_view_deg == 40);
}

TEST_CASE("scene: what the file leaves out has the documented value")
{
    const Scene scene = read_scene(
        R"({"name": "s", "dt": 0.1, "duration": 1, "bodies": [{"name": "b", "type": "static", "shape": {"tetrahedron": {"edge": 1}}}]})",
        "", "s.json", {});
    CHECK(scene.world.gravity == Vec3(0, -9.81, 0));
    CHECK(scene.contact.method == PenaltyMethod::continuous);
    CHECK(scene.contact.stiffness == 1000);
    CHECK_FALSE(scene.contact.max_depenetration_velocity.has_value());
    CHECK_FALSE(scene.contact.wanted_depth.has_value());
    CHECK_FALSE(scene.gives_stiffness);
    CHECK(scene.world.planes.empty());
}

TEST_CASE("scene: where it asks for exact contact, a solver whose springs give is refused, with the place")
{
    Solver gives, exact;
    gives.name = "chapter 0";
    exact.exact = true;
    const Scene asks = ball(R"({"contact": {"exact": true}})");
    CHECK_NOTHROW(require_asked(asks, exact));
    CHECK_THROWS_WITH_AS(require_asked(asks, gives),
                         "ball.json: /contact/exact: the springs of chapter 0 give under a load; choose a "
                         "solver of exact contact, or leave the key out",
                         InputError);
    for (const char* patch : {"", R"({"contact": {"exact": false}})"})
        CHECK_NOTHROW(require_asked(ball(patch), gives));
    CHECK(complaint(R"({"contact": {"exact": 1, "stiffness": -1}})") ==
          "ball.json: /contact/stiffness: expected a number above 0 up to 1e+12 [N/m], found -1\n"
          "ball.json: /contact/exact: expected true or false, found 1");
}

TEST_CASE("scene: density times volume is the mass, and a scale counts three times")
{
    const Scene scene = ball(
        R"({"/bodies/ball": {"mass": null, "density": 100, "shape": {"sphere": null, "box": {"size": [1, 2, 3]}, "scale": 0.1}}})");
    CHECK(scene.world.bodies[0]->mass() == doctest::Approx(100 * 6 * 1e-3));
}

TEST_CASE("scene: a rotation turns the shape about its own origin before it is moved")
{
    const Scene scene = ball(R"({"/bodies/floor": {"shape": {"plane_grid": null, "box": {"size": [2, 4, 6]}},
                                 "rotation": {"axis": [0, 0, 3], "angle_deg": 90}, "position": [10, 0, 0]}})");
    Vec3 low = Vec3::Constant(1e9), high = -low;
    for (const Vec3& vertex : scene.world.bodies[1]->positions_t0()) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    CHECK((low - Vec3(8, -1, -3)).norm() < 1e-14);
    CHECK((high - Vec3(12, 1, 3)).norm() < 1e-14);
}

TEST_CASE("scene: a soft body meets itself if it says so, and no other body may say it")
{
    const auto neighbours = [](const std::string& says) {
        const Scene scene = ball(
            R"({"/bodies/ball": {"type": "deformable", "young": 1e5, "poisson": 0.3,
                "shape": {"sphere": null, "bar": {"size": [1, 1, 1]}})" +
            says + "}}");
        return rest_neighbours(*scene.world.bodies[0]);
    };
    CHECK(neighbours("") == nullptr);
    CHECK(neighbours(R"(, "self_contact": false)") == nullptr);
    const Scene scene = ball(
        R"({"/bodies/ball": {"type": "deformable", "young": 1e5, "poisson": 0.3, "self_contact": true,
            "shape": {"sphere": null, "bar": {"size": [1, 1, 1]}}}})");
    CHECK(rest_neighbours(*scene.world.bodies[0]) != nullptr);
    CHECK(complaint(R"({"/bodies/ball/self_contact": true})")
              .find("ball.json: /bodies/0/self_contact: unknown key") == 0);
    CHECK(
        complaint(R"({"/bodies/ball": {"type": "deformable", "young": 1e5, "poisson": 0.3, "self_contact": 1,
                        "shape": {"sphere": null, "bar": {"size": [1, 1, 1]}}}})") ==
        "ball.json: /bodies/0/self_contact: expected true or false, found 1");
}

TEST_CASE("scene: a soft body says which linear solver it has, and the fast one is the default")
{
    const auto says = [](const std::string& solver) {
        return R"({"/bodies/ball": {"type": "deformable", "young": 1e5, "poisson": 0.3,
                   "shape": {"sphere": null, "bar": {"size": [1, 1, 1], "cells": [2, 2, 2]}})" +
               solver + "}}";
    };
    const auto near_response = [&](const std::string& solver) {
        const Scene scene = ball(says(solver));
        Body& body = *scene.world.bodies[0];
        body.predict(Vec3(0, -9.81, 0), 0.01);
        const ElasticBody& elastic = dynamic_cast<const DeformableBody&>(body).elastic();
        return elastic.near_response(NodalVectors::Ones(3, elastic.node_count()));
    };
    const NodalVectors simplicial = near_response(R"(, "linear_solver": "simplicial")"),
                       supernodal = near_response(R"(, "linear_solver": "supernodal")");
    CHECK(near_response("") == supernodal);
    CHECK((simplicial != supernodal) == has_supernodal_solver());  // one is in single precision
    CHECK((simplicial - supernodal).norm() <= 1e-4 * simplicial.norm());
    CHECK(complaint(says(R"(, "linear_solver": "fast")")).find("/bodies/0/linear_solver") !=
          std::string::npos);
}

TEST_CASE("scene: a change reaches one number, by index or by name")
{
    CHECK(ball(R"({"contact": {"stiffness": 750}})").contact.stiffness == 750);
    CHECK(ball(R"({"contact": {"stiffness": 750}})").contact.method == PenaltyMethod::discrete);
    CHECK(ball(R"({"/bodies/0/mass": 7})").world.bodies[0]->mass() == doctest::Approx(7));
    CHECK(ball(R"({"/bodies/ball/mass": 7})").world.bodies[0]->mass() == doctest::Approx(7));
    CHECK(complaint(R"({"/bodies/bell/mass": 7})") ==
          "ball.json: the change at /bodies/bell/mass leads nowhere: there is no /bodies/bell");
    CHECK(complaint("[1]") == "ball.json: a change must be a JSON object, found [1]");
}

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
    CHECK(complaint(R"({"/bodies/1/density": 5})") ==
          "ball.json: /bodies/1/density: unknown key; allowed here: \"name\", \"type\", "
          "\"shape\", \"position\", \"rotation\", \"look\", \"material\", \"motion\", \"surface_velocity\", "
          "\"sheet\"");
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

TEST_CASE("scene: a mesh is found beside the scene first")
{
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "enduring_scene_mesh";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "one.obj")
        << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    std::ofstream(folder / "s.json") << R"({"name": "s", "dt": 0.1, "duration": 1, "bodies": [
        {"name": "t", "type": "rigid", "mass": 1, "shape": {"file": "one.obj", "scale": 2}},
        {"name": "bunny", "type": "rigid", "mass": 1, "shape": {"file": "bunny_363.msh"}}]})";
    const Scene scene = load_scene(folder / "s.json");
    CHECK(scene.world.bodies[0]->surface().faces().size() == 4);
    CHECK(scene.world.bodies[0]->positions_t0()[1].norm() == doctest::Approx(2));
    CHECK(scene.world.bodies[1]->surface().is_closed());
    std::ofstream(folder / "one.obj") << "v 0 0 0\nf 1 2 3\n";
    CHECK_THROWS_WITH_AS(load_scene(folder / "s.json"), doctest::Contains("s.json: /bodies/0/shape/file: "),
                         InputError);
    CHECK_THROWS_WITH_AS(load_scene(folder / "s.json"), doctest::Contains("one.obj"), InputError);
    std::filesystem::remove_all(folder);
}

namespace {

const std::string jelly_text = R"({
  "name": "jelly", "dt": 0.01, "duration": 1,
  "bodies": [{"name": "bar", "type": "deformable", "shape": {"bar": {"size": [1, 0.5, 0.5], "cells": [2, 1, 1]}},
              "density": 400, "young": 1e5, "poisson": 0.3}]
})";

Scene jelly(const std::string& patch) { return read_scene(jelly_text, patch, "jelly.json", {{"/nowhere"}}); }

std::string jelly_complaint(const std::string& patch)
{
    return complaint_of([&] { jelly(patch); });
}

}  // namespace

TEST_CASE("scene: a deformable body has the material, basis, motion and supports of the file")
{
    const Scene scene = jelly(
        R"({"/bodies/bar": {"density": null, "mass": 30, "young": 2e5, "poisson": 0.4, "basis": "quadratic",
        "rayleigh": {"mass": 0.5, "stiffness": 0.01}, "fixed": {"max": [-0.5, 9, 9]}, "velocity": [0, 1, 0]}})");
    const auto& body = dynamic_cast<const DeformableBody&>(*scene.world.bodies[0]);
    CHECK(body.mass() == doctest::Approx(30));
    CHECK(body.elastic().material().density == doctest::Approx(120));
    CHECK(body.elastic().material().young == 2e5);
    CHECK(body.elastic().material().poisson == 0.4);
    CHECK(body.elastic().material().mass_damping == 0.5);
    CHECK(body.elastic().material().stiffness_damping == 0.01);
    CHECK(body.elastic().mesh().basis() == Basis::quadratic);
    int fixed = 0;
    for (Eigen::Index node = 0; node < body.elastic().positions().cols(); ++node) {
        const bool at_end = body.elastic().mesh().rest()(0, node) < -0.4999;
        CHECK((body.elastic().inverse_masses()[node] == 0) == at_end);
        fixed += at_end;
    }
    CHECK(fixed == 9);  // four corners, four edges, one diagonal of the end
    CHECK(jelly("").world.bodies[0]->mass() == doctest::Approx(100));
    const auto basis_of = [](const std::string& patch) {
        return dynamic_cast<const DeformableBody&>(*jelly(patch).world.bodies[0]).elastic().mesh().basis();
    };
    CHECK(basis_of("") == Basis::quadratic);
    CHECK(basis_of(R"({"/bodies/bar/basis": "linear"})") == Basis::linear);
    const auto law_of = [](const std::string& patch) {
        return dynamic_cast<const DeformableBody&>(*jelly(patch).world.bodies[0]).elastic().material().law;
    };
    CHECK(law_of("") == ElasticLaw::corotated);
    CHECK(law_of(R"({"/bodies/bar/elasticity": "corotated"})") == ElasticLaw::corotated);
    CHECK(law_of(R"({"/bodies/bar/elasticity": "corotated_at_points"})") == ElasticLaw::corotated_at_points);
    CHECK(law_of(R"({"/bodies/bar/elasticity": "neo_hookean"})") == ElasticLaw::neo_hookean);
    CHECK(jelly(R"({"/bodies/bar/shape/scale": 2})").world.bodies[0]->mass() == doctest::Approx(800));
}

TEST_CASE("scene: elastic constants out of range are named with path, range and value")
{
    CHECK(jelly_complaint(R"({"/bodies/0/young": 0})") ==
          "jelly.json: /bodies/0/young: expected a number from 0.001 to 1e+13 [Pa], found 0");
    CHECK(jelly_complaint(R"({"/bodies/0/poisson": 0.5})") ==
          "jelly.json: /bodies/0/poisson: expected a number from -0.99 to 0.4999, found 0.5");
    CHECK(jelly_complaint(R"({"/bodies/0/poisson": -1})") ==
          "jelly.json: /bodies/0/poisson: expected a number from -0.99 to 0.4999, found -1");
    CHECK(jelly_complaint(R"({"/bodies/0/density": 0})") ==
          "jelly.json: /bodies/0/density: expected a number from 0.001 to 1e+06 [kg/m^3], found 0");
    CHECK(jelly_complaint(R"({"/bodies/0/rayleigh": {"mass": -1}})") ==
          "jelly.json: /bodies/0/rayleigh/mass: expected a number from 0 to 1e+06 [1/s], found -1");
    CHECK(jelly_complaint(R"({"/bodies/0": {"young": null}})") ==
          "jelly.json: /bodies/0: the key \"young\" is missing");
    CHECK(jelly_complaint(R"({"/bodies/0/elasticity": "rubber"})").find("/bodies/0/elasticity") !=
          std::string::npos);
    CHECK(jelly_complaint(R"({"/bodies/0/basis": "cubic"})") ==
          "jelly.json: /bodies/0/basis: expected one of \"linear\", \"quadratic\", found \"cubic\"");
    CHECK(jelly_complaint(R"({"/bodies/0/fixed": {"min": [7, 0, 0]}})") ==
          "jelly.json: /bodies/0/fixed: no node of the shape lies in this region");
    CHECK(jelly_complaint(R"({"/bodies/0/shape": {"bar": null, "sphere": {"radius": 1}}})")
              .find("jelly.json: /bodies/0/shape: expected a shape made of tetrahedra") == 0);
    CHECK(jelly_complaint(R"({"/bodies/0/shape/bar/cells": [100, 100, 100]})") ==
          "jelly.json: /bodies/0/shape/bar: asks for 5000000 elements; at most 300000 are allowed");
}

TEST_CASE("scene: an open surface may be a static body, and a rigid one only as a sheet with a mass")
{
    CHECK(ball(R"({"/bodies/floor/shape/plane_grid/diagonals": "crossed"})")
              .world.bodies[1]
              ->surface()
              .faces()
              .size() == 24);
    CHECK(complaint(R"({"/bodies/floor": {"type": "rigid", "mass": 1}})")
              .find("ball.json: /bodies/1/shape: its mesh: ") == 0);
    const Scene sheet = ball(R"({"/bodies/floor": {"type": "rigid", "mass": 3, "sheet": true}})");
    CHECK(sheet.world.bodies[1]->mass() == 3);
    CHECK_FALSE(sheet.world.bodies[1]->is_static());
    CHECK(complaint(R"({"/bodies/floor": {"type": "rigid", "density": 3, "sheet": true}})") ==
          "ball.json: /bodies/1/density: a sheet has no volume; give its \"mass\"");
    CHECK(complaint(R"({"/bodies/floor": {"type": "rigid", "sheet": true}})") ==
          "ball.json: /bodies/1: the key \"mass\" is missing");
}

TEST_CASE("scene: every scene of the course loads under its own name and stands a step without contact")
{
    int scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(scene_file("any").parent_path())) {
        if (entry.path().extension() != ".json")
            continue;
        CAPTURE(entry.path());
        Scene scene = load_scene(entry.path());
        CHECK(scene.name == entry.path().stem());
        CHECK_FALSE(scene.description.empty());
        Contacts contacts;
        advance(scene.world, contacts, {}, scene.dt);
        ++scenes;
    }
    CHECK(scenes > 0);
}

TEST_CASE("scene: read twice and run, it gives the same bytes")
{
    std::vector<std::vector<Vec3>> ends;
    for (int run = 0; run < 2; ++run) {
        Scene scene = ball(R"({"/bodies/ball": {"angular_velocity": [1, 2, 3]}})");
        scene.world.bodies.push_back(
            std::move(jelly(R"({"/bodies/0/angular_velocity": [2, 0, 1]})").world.bodies[0]));
        Contacts contacts;
        for (int step = 0; step < 20; ++step)
            advance(scene.world, contacts, {}, scene.dt);
        ends.emplace_back();
        for (const std::unique_ptr<Body>& body : scene.world.bodies)
            ends.back().insert(ends.back().end(), body->positions_t0().begin(), body->positions_t0().end());
    }
    CHECK(ends[0] == ends[1]);
}
