#include "common/geometry/tests/complaint.hpp"
#include "common/input/input_error.hpp"
#include "common/scenes/drawn_body.hpp"
#include "common/scenes/scene_reader.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/step.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

using namespace enduring;

namespace {

const std::string in_folder = (std::filesystem::temp_directory_path() / "enduring_frames").string();

Scene read(const std::string& body)
{
    std::filesystem::create_directories(in_folder);
    return read_scene(
        R"({"name": "f", "dt": 0.01, "duration": 1, "bodies": [{"name": "one", )" + body + "}]}", "",
        "f.json", {{in_folder}});
}

std::string complaint(const std::string& body)
{
    return complaint_of([&] { read(body); });
}

const std::string rigid = R"("type": "rigid", "mass": 3, )";
const std::string square = R"("vertices": [[0, 0, 0], [2, 0, 0], [2, 0, 1], [0, 0, 1]])";

void write(const std::string& name, const std::string& text)
{
    std::filesystem::create_directories(in_folder);
    std::ofstream(in_folder + "/" + name) << text;
}

}  // namespace

TEST_CASE("frames in a scene: points and edges, in the file or in an OBJ file, are the same body")
{
    write("frame.obj", "v 0 0 0\nv 2 0 0\nv 2 0 1\nv 0 0 1\nl 1 2 3\nl -1 3\n");
    write("cloud.obj", "v 0 0 0\nv 2 0 0\nv 2 0 1\nv 0 0 1\n");
    const Scene here = read(rigid + R"("shape": {"wire": {)" + square +
                            R"(, "edges": [[1, 0], [1, 2], [2, 3]]}})"),
                there = read(rigid + R"("shape": {"wire": {"file": "frame.obj"}})"),
                cloud = read(rigid + R"("shape": {"points": {)" + square + "}}"),
                from_file = read(rigid + R"("shape": {"points": {"file": "cloud.obj"}})");
    const auto& one = dynamic_cast<const RigidBody&>(*here.world.bodies[0]);
    const auto& other = dynamic_cast<const RigidBody&>(*there.world.bodies[0]);
    CHECK(one.surface().edges().size() == 3);
    CHECK(one.surface().faces().empty());
    CHECK_FALSE(one.surface().is_closed());
    CHECK(std::equal(one.surface().edges().begin(), one.surface().edges().end(),
                     other.surface().edges().begin(), other.surface().edges().end()));
    // 2 m and 2 m and 1 m long, so 6/5, 3/5 and 6/5 kg about x = 1, 2, 1
    CHECK((one.motion().centre() - Vec3(1.2, 0, 0.5)).norm() <= 1e-14);
    CHECK((other.motion().centre() - one.motion().centre()).norm() == 0);
    CHECK(
        (dynamic_cast<const RigidBody&>(*cloud.world.bodies[0]).motion().centre() - Vec3(1, 0, 0.5)).norm() <=
        1e-14);
    CHECK(from_file.world.bodies[0]->surface().edges().empty());
    CHECK(here.asks_frames == "f.json: /bodies/0/shape");
}

TEST_CASE("frames in a scene: what is wrong is told with its place")
{
    const auto wire = [](const std::string& keys) { return rigid + R"("shape": {"wire": {)" + keys + "}}"; };
    CHECK(
        complaint(wire(square + R"(, "edges": [[0, 4]])")).find("f.json: /bodies/0/shape/wire/edges/0/1: ") ==
        0);
    CHECK(complaint(wire(square + R"(, "edges": [[0, 1], [1, 1]])")).find("edge 1 names a vertex twice") !=
          std::string::npos);
    CHECK(complaint(wire(square + R"(, "edges": [[0, 1], [2, 1], [1, 2], [2, 3]])"))
              .find("the edge between the vertices 1 and 2 is there twice") != std::string::npos);
    CHECK(complaint(wire(square + R"(, "edges": [[0, 1]])")).find("vertex 2 is in no edge") !=
          std::string::npos);
    CHECK(complaint(wire(R"("vertices": [[0, 0, 0], [0, 0, 0]], "edges": [[0, 1]])")).find("has no length") !=
          std::string::npos);
    CHECK(complaint(rigid + R"("shape": {"points": {"vertices": [[1, 0, 0], [1, 0, 0]]}})")
              .find("at one place") != std::string::npos);
    CHECK(complaint(R"("type": "rigid", "density": 2, "shape": {"points": {)" + square + "}}")
              .find("f.json: /bodies/0/density: points and edges have no volume") == 0);
    CHECK(complaint(rigid + R"("sheet": true, "shape": {"points": {)" + square + "}}")
              .find("f.json: /bodies/0/sheet: ") == 0);
    CHECK(complaint(R"("type": "deformable", "young": 1, "poisson": 0, "mass": 1, "shape": {"points": {)" +
                    square + "}}")
              .find("f.json: /bodies/0/shape: expected a shape made of tetrahedra") == 0);
    write("face.obj", "v 0 0 0\nv 2 0 0\nv 2 0 1\nf 1 2 3\n");
    write("line.obj", "v 0 0 0\nv 2 0 0\nl 1\n");
    write("far.obj", "v 0 0 0\nv 2 0 0\n\nl 1 3\n");
    write("good.obj", "v 0 0 0\nv 2 0 0\nl 1 2\n");
    const auto of_file = [&](const char* name) {
        return complaint(wire(std::string(R"("file": ")") + name + "\""));
    };
    CHECK(of_file("face.obj").find("face.obj:4: a face") != std::string::npos);
    CHECK(of_file("line.obj").find("line.obj:3: a line with 1 vertices") != std::string::npos);
    CHECK(of_file("far.obj").find("far.obj:4: the line names vertex 3; the file has 1 to 2") !=
          std::string::npos);
    CHECK(of_file("good.ply").find("there is no mesh file") != std::string::npos);
    CHECK(complaint(rigid + R"("shape": {"points": {"file": "good.obj"}})").find("the file has lines") !=
          std::string::npos);
}

TEST_CASE("frames in a scene: nothing turns about the line on which all points lie")
{
    const std::string pin = rigid +
                            R"("shape": {"wire": {"vertices": [[0, 0, 0], [0, 0, 2]], "edges": [[0, 1]]}})";
    CHECK_NOTHROW(read(pin + R"(, "angular_velocity": [3, 4, 0])"));
    CHECK(complaint(pin + R"(, "angular_velocity": [3, 4, 0.1])")
              .find("f.json: /bodies/0/angular_velocity: ") == 0);
    CHECK(complaint(pin + R"(, "forces": [{"torque": [0, 0, 1]}])")
              .find("f.json: /bodies/0/forces/0/torque: ") == 0);
    CHECK_NOTHROW(read(rigid + R"("angular_velocity": [3, 4, 5], "shape": {"points": {)" + square + "}}"));
}

TEST_CASE("frames in a scene: a solver whose pairs have sides refuses them, and tells the place")
{
    const Scene scene = read(rigid + R"("shape": {"points": {)" + square + "}}");
    Solver solver;
    solver.name = "chapter 7";
    CHECK_THROWS_WITH_AS(require_asked(scene, solver),
                         doctest::Contains("f.json: /bodies/0/shape: chapter 7 asks"), InputError);
    solver.has_frames = true;
    CHECK_NOTHROW(require_asked(scene, solver));
}

TEST_CASE("frames in a scene: pictures show a rod along each edge and something at each lonely point")
{
    const Scene wire = read(rigid + R"("shape": {"wire": {)" + square +
                            R"(, "edges": [[0, 1], [1, 2], [2, 3]]}})"),
                cloud = read(rigid + R"("shape": {"points": {)" + square + "}}"),
                box = read(rigid + R"("shape": {"box": {"size": [1, 1, 1]}})");
    const Body &rods = *wire.world.bodies[0], &dots = *cloud.world.bodies[0], &solid = *box.world.bodies[0];
    const std::vector<Vec3> points = drawn_points(rods);
    CHECK(points.size() == 3 * 6);
    CHECK(drawn_points(dots).size() == 4 * 6);
    for (const Body* body : {&rods, &dots})
        for (const Face& face : drawn_faces(*body))
            for (const int corner : face)
                CHECK(corner < static_cast<int>(drawn_points(*body).size()));
    for (std::size_t i = 0; i < 6; ++i) {  // the first rod lies along the x axis
        CHECK(points[i].tail<2>().norm() <= 0.02);
        CHECK((points[i].x() == doctest::Approx(i < 3 ? 0 : 2)));
    }
    CHECK(vertices_of_drawn_face(rods, 17) == std::vector<int>{2, 3});
    CHECK(vertices_of_drawn_face(dots, 8) == std::vector<int>{1});
    CHECK(vertices_of_drawn_face(solid, 0).size() == 3);
    CHECK(drawn_faces(solid).size() == 12);
}

TEST_CASE("shapes over time: a static body that deforms is read, and rests where its last shape is")
{
    Scene scene = load_scene(scene_file("swelling"));
    Body& block = *scene.world.bodies[0];
    Contacts none;
    Solver solver;
    scene.world.bodies.resize(1);
    for (int step = 0; step < 200; ++step)
        advance(scene.world, none, solver, 0.01);
    double highest = 0;
    for (const Vec3& x : block.positions_t0())
        highest = std::max(highest, x.y());
    CHECK(block.is_static());
    CHECK(highest == doctest::Approx(0.1 + 1.5 * 0.2 + 0.1 * 0.5));
}

TEST_CASE("shapes over time: what is wrong is told with its place")
{
    const auto rows = [](const std::string& list) { return R"("type": "static", "shapes": [)" + list + "]"; };
    const std::string first = R"({"time": 0, "shape": {"box": {"size": [1, 1, 1]}}})",
                      later = R"({"time": 1, "shape": {"box": {"size": [1, 2, 1]}}})";
    CHECK_NOTHROW(read(rows(first + "," + later)));
    CHECK(complaint(rows(first)).find("f.json: /bodies/0/shapes: ") == 0);
    CHECK(
        complaint(rows(later + "," + first)).find("f.json: /bodies/0/shapes/1/time: is not a microsecond") ==
        0);
    CHECK(
        complaint(rows(first + R"(, {"time": 1, "shape": {"box": {"size": [1, 1, 1], "cells": [2, 1, 1]}}})"))
            .find("f.json: /bodies/0/shapes/1/shape: has 12 vertices, and the first shape has 8") == 0);
    CHECK(complaint(rows(first + R"(, {"time": 1, "shape": {"tetrahedron": {"edge": 1}}})"))
              .find("f.json: /bodies/0/shapes/1/shape: has 4 vertices") == 0);
    write("one.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 0 1\n0 0 1\n4 0 1 2 3\n");
    write("two.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 0 1\n0 0 1\n3 1 2 3\n3 0 1 3\n");
    CHECK(complaint(
              rows(R"({"time": 0, "shape": {"file": "one.off"}}, {"time": 1, "shape": {"file": "two.off"}})"))
              .find("/shapes/1/shape: its face 0 has other vertices than in the first shape") !=
          std::string::npos);
    CHECK(complaint(rows(first + "," + later) + R"(, "motion": {"velocity": [1, 0, 0]})")
              .find("f.json: /bodies/0/motion: stands beside") == 0);
    CHECK(complaint(rows(first + "," + later) + R"(, "shape": {"box": {"size": [1, 1, 1]}})")
              .find("f.json: /bodies/0/shape: stands beside") == 0);
    CHECK(complaint(rigid + R"("shapes": [], "shape": {"box": {"size": [1, 1, 1]}})")
              .find("f.json: /bodies/0/shapes: unknown key") == 0);
}
