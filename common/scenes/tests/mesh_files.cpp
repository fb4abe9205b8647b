#include "common/experiments/report/tests/temporary_folder.hpp"
#include "common/geometry/tests/complaint.hpp"
#include "common/scenes/scene_reader.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

using namespace enduring;

namespace {

/// A folder with a tetrahedron, whole (one.obj) and with three vertices of its own for each face
/// (pieces.obj).
struct MeshFolder : TemporaryFolder {
    MeshFolder()
    {
        std::ofstream(path / "one.obj")
            << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
        std::ofstream(path / "pieces.obj")
            << "v 0 0 0\nv 0 1 0\nv 1 0 0\nf 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 0 1\nf 4 5 6\n"
            << "v 0 0 0\nv 0 0 1\nv 0 1 0\nf 7 8 9\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 10 11 12\n";
        std::ofstream(path / "STEP.stp") << "ISO-10303-21;\n";
    }

    Scene with(const std::string& shape, const std::string& keys = "") const
    {
        return read_scene(
            R"({"name": "s", "dt": 0.1, "duration": 1, "bodies": [{"name": "part", "type": "rigid", "mass": 1, "shape": )" +
                shape + keys + "}]}",
            "", "s.json", {{path}});
    }
    std::string complaint(const std::string& shape, const std::string& keys = "") const
    {
        return complaint_of([&] { with(shape, keys); });
    }
};

}  // namespace

TEST_CASE("mesh files: a surface in pieces is no rigid body until its vertices are welded")
{
    const MeshFolder folder;
    CHECK(folder.complaint(R"({"file": "pieces.obj"})").find("the surface is not closed") !=
          std::string::npos);
    CHECK(folder.complaint(R"({"file": "pieces.obj", "weld": false})") != "no complaint");
    const Scene scene = folder.with(R"({"file": "pieces.obj", "weld": true})");
    CHECK(scene.world.bodies[0]->surface().vertex_count() == 4);
    CHECK(scene.world.bodies[0]->surface().is_closed());
    CHECK(
        folder.complaint(R"({"box": {"size": [1, 1, 1]}, "weld": true})") ==
        "s.json: /bodies/0/shape/weld: only the vertices of a surface file (.obj, .off, .stl, .ply) can be welded");
    CHECK(
        folder.complaint(R"({"file": "STEP.stp"})")
            .find("s.json: /bodies/0/shape/file: expected a mesh file ending in .msh (tetrahedra) or .obj") ==
        0);
}

TEST_CASE("mesh files: a transform is applied behind the scale, and may not mirror")
{
    const MeshFolder folder;
    // from millimetres with z up: (x, y, z) goes to (x, z, -y), and then 5 m along x
    const Scene scene = folder.with(
        R"({"file": "one.obj", "scale": 0.5, "transform": [[1, 0, 0, 5], [0, 0, 1, 0], [0, -1, 0, 0]]})");
    const auto vertices = scene.world.bodies[0]->positions_t0();
    CHECK(vertices[0] == Vec3(5, 0, 0));
    CHECK(vertices[1] == Vec3(5.5, 0, 0));
    CHECK(vertices[2] == Vec3(5, 0, -0.5));
    CHECK(vertices[3] == Vec3(5, 0.5, 0));
    const auto refused = [&](const std::string& transform) {
        return folder.complaint(R"({"file": "one.obj", "transform": )" + transform + "}");
    };
    CHECK(refused("[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, -1, 0]]").find("determinant") != std::string::npos);
    CHECK(refused("[[1, 0, 0, 0], [0, 1, 0, 0], [1, 1, 0, 0]]").find("determinant") != std::string::npos);
    CHECK(refused("[[1, 0, 0], [0, 1, 0], [0, 0, 1]]").find("s.json: /bodies/0/shape/transform/0: ") == 0);
}

TEST_CASE("mesh files: a rotation by a quaternion is the one by its axis and angle")
{
    const MeshFolder folder;
    const std::string part = R"({"file": "one.obj"})";
    // about (1, 2, 3) by 80 degrees, not normalised: cos 40, sin 40 (1, 2, 3) / sqrt 14
    const Scene by_axis = folder.with(part, R"(, "rotation": {"axis": [1, 2, 3], "angle_deg": 80})");
    const Scene by_quaternion = folder.with(
        part,
        R"(, "rotation": {"quaternion": [2.298133329356934, 0.5153766445522296, 1.0307532891044593, 1.5461299336566887]})");
    for (std::size_t v = 0; v < 4; ++v)
        CHECK((by_axis.world.bodies[0]->positions_t0()[v] - by_quaternion.world.bodies[0]->positions_t0()[v])
                  .norm() < 1e-14);
    CHECK(folder.complaint(part, R"(, "rotation": {"quaternion": [0, 0, 0, 0]})")
              .find("s.json: /bodies/0/rotation/quaternion: expected four numbers that are not all zero") ==
          0);
    CHECK(folder.complaint(part, R"(, "rotation": {"quaternion": [1, 0, 0, 0], "axis": [1, 0, 0]})")
              .find("s.json: /bodies/0/rotation/quaternion: stands beside") == 0);
}

TEST_CASE("mesh files: a surface is mended where it is asked for, and what was mended is told")
{
    const MeshFolder folder;
    std::ofstream(folder.path / "twice.obj")
        << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\nf 3 4 2\n";
    CHECK(folder.complaint(R"({"file": "twice.obj"})").find("faces 3 and 4 are two over the same vertices") !=
          std::string::npos);
    const Scene scene = folder.with(R"({"file": "twice.obj", "mend": true})");
    CHECK(scene.world.bodies[0]->surface().faces().size() == 4);
    CHECK(scene.warnings ==
          std::vector<std::string>{
              "s.json: /bodies/0/shape/mend: 1 face over the vertices of another one taken out"});
    CHECK(folder.with(R"({"file": "one.obj", "mend": true})").warnings.empty());
    CHECK(folder.complaint(R"({"box": {"size": [1, 1, 1]}, "mend": true})") ==
          "s.json: /bodies/0/shape/mend: only a surface file (.obj, .off, .stl, .ply) can be mended");
}
