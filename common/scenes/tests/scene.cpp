#include "common/scenes/scene.hpp"
#include "common/input/input_error.hpp"
#include "common/scenes/tests/small_scenes.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/step.hpp"

#include <doctest/doctest.h>

#include <fstream>

using namespace enduring;
using namespace enduring::tests;

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
