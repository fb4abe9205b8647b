#include "common/geometry/box_shapes.hpp"
#include "common/geometry/quadratic.hpp"
#include "common/geometry/read_gmsh.hpp"
#include "common/geometry/read_obj.hpp"
#include "common/geometry/solid_checks.hpp"
#include "common/geometry/surface_checks.hpp"
#include "common/geometry/surface_extraction.hpp"
#include "common/geometry/tests/complaint.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <limits>
#include <sstream>

using namespace enduring;

namespace {

const std::string header = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const std::string corners = "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n";
const std::string one_element = "$Elements\n1\n1 4 2 1 1 1 2 3 4\n$EndElements\n";

std::string gmsh_complaint(const std::string& text)
{
    return complaint_of([&] {
        std::istringstream stream(text);
        read_gmsh(stream, "m.msh");
    });
}

std::string obj_complaint(const std::string& text)
{
    return complaint_of([&] {
        std::istringstream stream(text);
        read_obj(stream, "m.obj");
    });
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    REQUIRE(text.find(from) != std::string::npos);
    return text.replace(text.find(from), from.size(), to);
}

}  // namespace

TEST_CASE("Gmsh reader: each kind of bad file is refused with file, line and reason")
{
    const std::string good = header + corners + one_element;
    CHECK(gmsh_complaint(good) == "no complaint");
    const std::vector<std::array<std::string, 2>> cases{
        {"", "m.msh: the file is empty"},
        {"\n \n", "m.msh: the file is empty"},
        {std::string("\x7f"
                     "ELF\0",
                     5),
         "m.msh:1: binary data"},
        {replaced(good, "2.2 0 8", "2.2 2 8"), "m.msh:2: the file type is neither"},
        {replaced(good, "2.2 0 8", "2.2 1 8"), "m.msh, byte 24: the number 1 was expected"},
        {replaced(good, "2.2", "4.0"), "m.msh:2: Gmsh format '4.0' is not supported"},
        {corners, "m.msh:1: not a Gmsh file"},
        {"solid cube\n", "m.msh:1: a section such as $Nodes expected"},
        {header + corners, "m.msh:10: the file ends without a tetrahedron"},
        {header + "$Nodes\n4\n1 0 0 0\n", "m.msh:6: the file ends where $EndNodes is missing"},
        {good.substr(0, good.size() - 13), "m.msh:13: the file ends where $EndElements is missing"},
        {replaced(good, "4\n1 0 0 0", "5\n1 0 0 0"), "m.msh:10: $Nodes promises 5 entries and ends after 4"},
        {replaced(good, "4\n1 0 0 0", "3\n1 0 0 0"), "m.msh:9: $Nodes promises 3 entries and goes on"},
        {replaced(good, "4\n1 0 0 0", "9000000000000000000\n1 0 0 0"),
         "m.msh:10: $Nodes promises 9000000000000000000"},
        {replaced(good, "4\n1 0 0 0", "-4\n1 0 0 0"), "m.msh:5: $Nodes holds -4 entries"},
        {replaced(good, "4\n1 0 0 0", "99999999999999999999\n1 0 0 0"),
         "m.msh:5: count is '99999999999999999999'"},
        {replaced(good, "2 1 0 0", "2 nan 0 0"), "m.msh:7: coordinate is 'nan', not a finite number"},
        {replaced(good, "2 1 0 0", "2 inf 0 0"), "m.msh:7: coordinate is 'inf', not a finite number"},
        {replaced(good, "2 1 0 0", "2 1e999 0 0"), "m.msh:7: coordinate is '1e999', not a finite number"},
        {replaced(good, "2 1 0 0", "2 one 0 0"), "m.msh:7: coordinate is 'one', not a number"},
        {replaced(good, "2 1 0 0", "2 1 0"), "m.msh:7: coordinate is missing"},
        {replaced(good, "2 1 0 0", "1 1 0 0"), "m.msh:7: node 1 is given twice"},
        {replaced(good, "1 2 3 4\n", "1 2 3 5\n"), "m.msh:13: element 1 names node 5, which does not exist"},
        {replaced(good, "1 2 3 4\n", "1 2 3 3\n"), "m.msh:13: element 1 names node 3 twice"},
        {replaced(good, "1 2 3 4\n", "1 2 3\n"), "m.msh:13: node is missing"},
        {replaced(good, "1 2 3 4\n", "1 2 3 4 4\n"), "m.msh:13: element 1 names too many nodes"},
        {replaced(good, "1 2 3 4\n", "2 1 3 4\n"),
         "m.msh:13: element 1 is inverted: its volume is -0.166667 m^3"},
        {replaced(good, "4 0 0 1", "4 1 1 0"), "m.msh:13: element 1 is flat: its volume is 0 m^3"},
        {replaced(good, "4 0 0 1", "4 0 0 1e200"), "m.msh:13: element 1 is too large"},
        {replaced(good, "1 4 2 1 1", "1 4 -2 1 1"), "m.msh:13: element 1 has -2 tags, below zero"},
        {replaced(good, "1 4 2 1 1", "1 5 2 1 1"), "m.msh:13: element 1 is of type 5"},
        {replaced(good, "1 4 2 1 1 1 2 3 4", "1 2 2 1 1 1 2 3"),
         "m.msh:14: the file ends without a tetrahedron"},
    };
    for (const auto& one : cases) {
        const std::string &text = one[0], &expected = one[1];
        CAPTURE(text);
        const std::string got = gmsh_complaint(text);
        CAPTURE(got);
        CHECK(got.substr(0, expected.size()) == expected);
    }
}

TEST_CASE("Gmsh reader: a file of blocks, version 4.1, is refused with file, line and reason where it breaks")
{
    const std::string good =
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
        "$Nodes\n2 4 1 4\n2 1 0 3\n1\n2\n3\n0 0 0\n1 0 0\n0 1 0\n3 1 0 1\n4\n0 0 1\n$EndNodes\n"
        "$Elements\n2 2 1 2\n2 1 2 1\n1 1 2 3\n3 1 4 1\n2 1 2 3 4\n$EndElements\n";
    CHECK(gmsh_complaint(good) == "no complaint");
    const std::vector<std::array<std::string, 2>> cases{
        {replaced(good, "4.1 0 8", "4.1 1 4"), "m.msh, byte 20: this binary Gmsh format is not supported"},
        {replaced(good, "2 4 1 4", "3 4 1 4"),
         "m.msh:16: $Nodes promises 4 entries in 3 blocks and has 4 in 2"},
        {replaced(good, "2 4 1 4", "-2 4 1 4"), "m.msh:5: $Nodes has a count of -2, below zero"},
        {replaced(good, "2 4 1 4", "1 4 1 4"), "m.msh:13: $Nodes promises 1 blocks and goes on"},
        {replaced(good, "2 4 1 4", "2 5 1 4"),
         "m.msh:16: $Nodes promises 5 entries in 2 blocks and has 4 in 2"},
        {replaced(good, "3 1 0 1\n4", "3 1 0 2\n4"),
         "m.msh:16: a block of $Nodes ends before it has what it promises"},
        {replaced(good, "3 1 0 1\n4", "3 1 0 -1\n4"), "m.msh:13: a block of -1 entries"},
        {replaced(good, "3 1 0 1\n4\n0 0 1", "3 1 0 9000000000000000000\n4"),
         "m.msh:15: a block of $Nodes ends before it has what it promises"},
        {replaced(good, "0 1 0\n", "0 1 inf\n"), "m.msh:12: coordinate is 'inf', not a finite number"},
        {replaced(good, "\n4\n0 0 1", "\n3\n0 0 1"), "m.msh:15: node 3 is given twice"},
        {replaced(good, "3 1 4 1", "3 1 5 1"), "m.msh:22: element 2 is of type 5"},
        {replaced(good, "2 1 2 3 4\n", "2 1 2 3 5\n"),
         "m.msh:22: element 2 names node 5, which does not exist"},
        {replaced(good, "2 1 2 3 4\n", "2 2 1 3 4\n"), "m.msh:22: element 2 is inverted"},
        {replaced(good, "3 1 4 1\n2 1 2 3 4\n", "3 1 4 1\n"),
         "m.msh:22: a block of $Elements ends before it has what it promises"},
    };
    for (const auto& [text, expected] : cases) {
        CAPTURE(text);
        const std::string got = gmsh_complaint(text);
        CAPTURE(got);
        CHECK(got.substr(0, expected.size()) == expected);
    }
}

TEST_CASE("mesh readers: a missing file and a folder are refused by name")
{
    CHECK(complaint_of([] { read_gmsh("/nowhere/bunny.msh"); }) == "/nowhere/bunny.msh: no such file");
    CHECK(complaint_of([] { read_obj("/nowhere/bunny.obj"); }) == "/nowhere/bunny.obj: no such file");
    const std::string folder = std::filesystem::temp_directory_path().string();
    CHECK(complaint_of([&] { read_gmsh(folder); }) == folder + ": is a folder, and a file is needed");
    CHECK(complaint_of([&] { read_obj(folder); }) == folder + ": is a folder, and a file is needed");
}

TEST_CASE("OBJ reader: each kind of bad file is refused with file, line and reason")
{
    const std::string good = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    CHECK(obj_complaint(good) == "no complaint");
    const std::vector<std::array<std::string, 2>> cases{
        {"", "m.obj: the file is empty"},
        {std::string("v 0\0 0", 6), "m.obj:1: binary data"},
        {"v 0 0 0\n", "m.obj:1: the file ends without a face"},
        {replaced(good, "v 1 0 0", "v 1 nan 0"), "m.obj:2: coordinate is 'nan', not a finite number"},
        {replaced(good, "v 1 0 0", "v 1 0"), "m.obj:2: coordinate is missing"},
        {replaced(good, "v 1 0 0", "v 1 0 x"), "m.obj:2: coordinate is 'x', not a number"},
        {replaced(good, "f 1 2 3", "f 1 2"), "m.obj:4: a face with 2 corners"},
        {replaced(good, "f 1 2 3", "f 1 2 4"), "m.obj:4: the face names vertex 4; the file has 1 to 3"},
        {replaced(good, "f 1 2 3", "f 1 2 -4"), "m.obj:4: the face names vertex 0; the file has 1 to 3"},
        {replaced(good, "f 1 2 3", "f 0 1 2"), "m.obj:4: '0' does not name a vertex"},
        {replaced(good, "f 1 2 3", "f a b c"), "m.obj:4: 'a' does not name a vertex"},
        {replaced(good, "f 1 2 3", "f 1 2 4294967297"), "m.obj:4: the face names vertex 4294967297"},
    };
    for (const auto& one : cases) {
        const std::string &text = one[0], &expected = one[1];
        CAPTURE(text);
        const std::string got = obj_complaint(text);
        CAPTURE(got);
        CHECK(got.substr(0, expected.size()) == expected);
    }
}

TEST_CASE("surface checks: what contact cannot live on is refused, with the reason")
{
    const SurfaceMesh cube = box({1, 1, 1});
    const auto refused = [](const SurfaceMesh& mesh, Border border = Border::refused) {
        return complaint_of([&] { check_surface(mesh, "cube", border); });
    };
    CHECK(refused(cube) == "no complaint");
    CHECK(refused({}) == "cube: the surface has no faces");

    SurfaceMesh open = cube;
    open.faces.pop_back();
    CHECK(refused(open).find("cube: the surface is not closed: the edge between vertices") == 0);
    CHECK(refused(open, Border::allowed) == "no complaint");

    SurfaceMesh flipped = cube;
    std::swap(flipped.faces[0][0], flipped.faces[0][1]);
    CHECK(
        refused(flipped) ==
        "cube: faces 0 and 9, neighbours of the surface, face opposite ways: both run along the edge between "
        "vertices 0 and 1 in the same direction");

    SurfaceMesh inside_out = cube;
    for (Face& face : inside_out.faces)
        std::swap(face[0], face[1]);
    CHECK(refused(inside_out) == "cube: the surface faces inwards: turn its faces around");

    SurfaceMesh fin = cube;
    fin.vertices.emplace_back(0, 3, 0);
    fin.faces.push_back({fin.faces[0][1], fin.faces[0][0], 8});
    CHECK(refused(fin, Border::allowed)
              .find("cube: the surface is not manifold: the edge between vertices " +
                    std::to_string(std::min(fin.faces[0][0], fin.faces[0][1])) + " and " +
                    std::to_string(std::max(fin.faces[0][0], fin.faces[0][1])) + " belongs to faces 0, ") ==
          0);

    SurfaceMesh bow_tie{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}};
    CHECK(refused(bow_tie, Border::allowed) ==
          "cube: the surface is not manifold: two parts of it touch in vertex 0 only, of faces 0 and 1");

    SurfaceMesh twice = cube;
    twice.faces.push_back(twice.faces[0]);
    CHECK(refused(twice).find("cube: faces 0 and 12 are two over the same vertices 0, ") == 0);

    SurfaceMesh flat = cube;
    flat.vertices[0] = flat.vertices[flat.faces[0][1]];
    CHECK(refused(flat) == "cube: face 0 has no area");

    SurfaceMesh stray = cube;
    stray.vertices.emplace_back(5, 5, 5);
    CHECK(refused(stray) == "cube: vertex 8 belongs to no face");

    SurfaceMesh infinite = cube;
    infinite.vertices[3].y() = std::numeric_limits<double>::infinity();
    CHECK(refused(infinite) == "cube: vertex 3 has a coordinate that is not finite");

    SurfaceMesh wild = cube;
    wild.faces[2][1] = 99;
    CHECK(refused(wild) == "cube: face 2 names a vertex outside [0, 8)");
    SurfaceMesh shifted = cube;  // so that vertex 0 belongs to no face
    for (Face& face : shifted.faces)
        for (int& vertex : face)
            ++vertex;
    CHECK(refused(shifted).find("names a vertex outside [0, 8)") != std::string::npos);
}

TEST_CASE("solid checks: inverted elements, stray nodes and solids that touch in an edge only are refused")
{
    const TetrahedralMesh good = bar({1, 1, 1}, {2, 1, 1});
    const auto refused = [](const auto& mesh) { return complaint_of([&] { check_solid(mesh, "bar"); }); };
    CHECK(refused(good) == "no complaint");
    CHECK(refused(with_edge_midpoints(good)) == "no complaint");
    CHECK(refused(TetrahedralMesh{}) == "bar: the mesh has no elements");

    TetrahedralMesh inverted = good;
    std::swap(inverted.elements[7][0], inverted.elements[7][1]);
    CHECK(refused(inverted).find("bar: element 7 is inverted: its volume is -0.08333") == 0);

    TetrahedralMesh stray = good;
    stray.nodes.emplace_back(0, 9, 0);
    CHECK(refused(stray) == "bar: node 12 belongs to no element");

    TetrahedralMesh wild = good;
    wild.elements[3][2] = -1;
    CHECK(refused(wild) == "bar: element 3 names node -1, which does not exist");

    // Two tetrahedra over one edge: the surface has four faces there.
    const TetrahedralMesh hinge{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}},
                                {{0, 2, 3, 1}, {0, 4, 5, 1}}};
    CHECK(
        refused(hinge) ==
        "bar: the surface is not manifold: the edge between nodes 0 and 1 belongs to 4 faces, and at most two may share it");

    TetrahedralMesh twice = good;
    twice.elements.push_back(twice.elements[4]);
    CHECK(refused(twice) == "bar: element 10 has the same nodes as element 4");

    // Three tetrahedra on one face.
    TetrahedralMesh crowded{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {0.2, 0.2, 2}},
                            {{0, 1, 2, 3}, {0, 2, 1, 4}, {0, 1, 2, 5}}};
    CHECK(refused(crowded) == "bar: more than two elements share the face over nodes 0, 1 and 2");
}
