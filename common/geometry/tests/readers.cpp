#include "common/geometry/element_quality.hpp"
#include "common/geometry/quadratic.hpp"
#include "common/geometry/read_gmsh.hpp"
#include "common/geometry/read_obj.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/geometry/solid_checks.hpp"
#include "common/geometry/surface_checks.hpp"
#include "common/geometry/surface_extraction.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/input/input_error.hpp"
#include "common/input/source_directory.hpp"

#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <iomanip>
#include <numbers>
#include <sstream>

using namespace enduring;

namespace {

const std::filesystem::path meshes = source_directory() / "common/meshes";

std::string gmsh_text(const std::vector<Vec3>& nodes, int type, const std::vector<std::vector<int>>& elements)
{
    std::ostringstream text;
    text << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Comments\nanything\n$EndComments\n$Nodes\n"
         << nodes.size() << "\n"
         << std::setprecision(17);
    for (std::size_t n = 0; n < nodes.size(); ++n)
        // numbers need not be dense
        text << 10 * n + 7 << " " << nodes[n].x() << " " << nodes[n].y() << " " << nodes[n].z() << "\n";
    // a triangle, to be passed over
    text << "$EndNodes\n$Elements\n" << elements.size() + 1 << "\n1 2 0 7 17 27\n";
    for (std::size_t e = 0; e < elements.size(); ++e) {
        text << e + 2 << " " << type << " 2 1 1";
        for (int node : elements[e])
            text << " " << 10 * node + 7;
        text << "\r\n";
    }
    text << "$EndElements\n";
    return text.str();
}

}  // namespace

TEST_CASE("Gmsh reader: what is written in 17 digits is read back to the last bit")
{
    TetrahedralMesh mesh = bar({1, 2, 3}, {2, 2, 1});
    for (Vec3& x : mesh.nodes)
        x = x / 3 + Vec3(0.1, 1e-17, 1e5);
    std::vector<std::vector<int>> elements;
    for (const auto& e : mesh.elements)
        elements.emplace_back(e.begin(), e.end());
    std::istringstream stream(gmsh_text(mesh.nodes, 4, elements));
    const TetrahedralMesh read = read_gmsh(stream, "text");
    CHECK(read.nodes == mesh.nodes);
    CHECK(read.elements == mesh.elements);
}

TEST_CASE("Gmsh reader: nodes that no tetrahedron uses are left out")
{
    std::istringstream stream(
        gmsh_text({{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {8, 8, 8}, {0, 1, 0}, {0, 0, 1}}, 4, {{1, 2, 4, 5}}));
    const TetrahedralMesh read = read_gmsh(stream, "text");
    CHECK(read.nodes == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    CHECK(read.elements == std::vector<std::array<int, 4>>{{0, 1, 2, 3}});
}

TEST_CASE("Gmsh reader: ten-node elements arrive in our order of edges, corners first")
{
    // Gmsh's own order: corners, then the middles of 01, 12, 02, 03, 23,
    // 13. Here the middles stand first in the file.
    const std::vector<Vec3> corner{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
    const std::array<std::array<std::size_t, 2>, 6> gmsh_edges{
        {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {2, 3}, {1, 3}}};
    std::vector<Vec3> nodes;
    for (const auto& [i, j] : gmsh_edges)
        nodes.push_back((corner[i] + corner[j]) / 2);
    nodes.insert(nodes.end(), corner.begin(), corner.end());
    const std::string text = gmsh_text(nodes, 11, {{6, 7, 8, 9, 0, 1, 2, 3, 4, 5}});

    std::istringstream stream(text), again(text);
    const QuadraticTetrahedralMesh read = read_gmsh_quadratic(stream, "text");
    CHECK(read.corner_count == 4);
    REQUIRE(read.elements.size() == 1);
    const auto node = [&](std::size_t i) { return read.nodes[read.elements[0][i]]; };
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(read.elements[0][i] < 4);
        CHECK(node(i) == corner[i]);
    }
    for (std::size_t e = 0; e < 6; ++e)
        CHECK(node(4 + e) == (node(static_cast<std::size_t>(tetrahedron_edges[e][0])) +
                              node(static_cast<std::size_t>(tetrahedron_edges[e][1]))) /
                                 2);
    CHECK(read_gmsh(again, "text").nodes == corner);
}

TEST_CASE(
    "Gmsh reader: the same mesh, saved by Gmsh as version 2.2 and as 4.1, arrives with the same elements in space")
{
    const std::filesystem::path seeds = source_directory() / "common/geometry/fuzz/seeds/gmsh_reader";
    for (const std::string order : {"1", "2"}) {
        CAPTURE(order);
        const QuadraticTetrahedralMesh old_format =
                                           read_gmsh_quadratic(seeds / ("box_order" + order + "_v22.msh")),
                                       new_format =
                                           read_gmsh_quadratic(seeds / ("box_order" + order + "_v41.msh"));
        CHECK_NOTHROW(check_solid(new_format, "box"));
        CHECK(new_format.corner_count == old_format.corner_count);
        REQUIRE(new_format.elements.size() == 24);
        REQUIRE(old_format.elements.size() == 24);
        double volume = 0;
        for (std::size_t e = 0; e < 24; ++e) {
            std::array<Vec3, 4> x;
            for (std::size_t i = 0; i < 10; ++i) {
                const Vec3& node = new_format.nodes[new_format.elements[e][i]];
                CHECK(node == old_format.nodes[old_format.elements[e][i]]);
                if (i < 4)
                    x[i] = node;
            }
            volume += signed_volume(x);
        }
        CHECK(volume == doctest::Approx(2));  // 1 x 2 x 1
    }
}

TEST_CASE("Gmsh reader: what Gmsh saves as a binary file arrives as from its text")
{
    const std::filesystem::path seeds = source_directory() / "common/geometry/fuzz/seeds/gmsh_reader";
    for (const std::string name : {"box_order1_v22", "box_order2_v22", "box_order1_v41", "box_order2_v41"}) {
        CAPTURE(name);
        const QuadraticTetrahedralMesh text = read_gmsh_quadratic(seeds / (name + ".msh")),
                                       binary = read_gmsh_quadratic(seeds / (name + "_binary.msh"));
        CHECK(binary.nodes == text.nodes);
        CHECK(binary.elements == text.elements);
        CHECK(binary.corner_count == text.corner_count);
    }
}

TEST_CASE(
    "Gmsh reader: a binary file of the other order of bytes is read, and one that is cut is refused with its byte")
{
    const auto number = [](auto value) {
        const auto bytes = std::bit_cast<std::array<char, sizeof(value)>>(value);
        return std::string(bytes.rbegin(), bytes.rend());
    };
    static_assert(std::endian::native == std::endian::little);
    std::ostringstream text;
    text << "$MeshFormat\n2.2 1 8\n" << number(1) << "\n$EndMeshFormat\n$Nodes\n4\n";
    const std::vector<Vec3> nodes{{0, 0, 0}, {0.1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    int next = 1;
    for (const Vec3& node : nodes)
        text << number(next++) << number(node.x()) << number(node.y()) << number(node.z());
    text << "\n$EndNodes\n$Elements\n1\n";
    for (const int part : {4, 1, 2, 1, 7, 7, 1, 2, 3, 4})
        text << number(part);
    const std::string file = text.str();
    std::istringstream whole(file + "\n$EndElements\n"), cut(file.substr(0, file.size() - 3)),
        wrong(file.substr(0, file.size() - 4) + number(9) + "\n$EndElements\n");
    CHECK(read_gmsh(whole, "m").nodes == nodes);
    CHECK_THROWS_WITH_AS(
        read_gmsh(cut, "m"),
        ("m, byte " + std::to_string(file.size() - 4) + ": the file ends where a number is missing").c_str(),
        InputError);
    CHECK_THROWS_WITH_AS(read_gmsh(wrong, "m"), "m, as text:13: element 1 names node 9, which does not exist",
                         InputError);
}

TEST_CASE("meshes: every bunny is sound, and what its README says")
{
    struct Bunny {
        std::string file;
        std::size_t nodes, elements, quadratic_nodes, faces;
        double volume, angle_deg;
    };
    const std::vector<Bunny> bunnies{{"bunny_363.msh", 160, 363, 836, 308, 177.4, 20.0},
                                     {"bunny_785.msh", 319, 785, 1722, 600, 184.0, 19.7},
                                     {"bunny_1452.msh", 520, 1452, 2956, 930, 187.3, 20.0},
                                     {"bunny_10668.msh", 2934, 10668, 18615, 4160, 192.5, 16.8}};
    for (const Bunny& bunny : bunnies) {
        CAPTURE(bunny.file);
        const TetrahedralMesh mesh = read_gmsh(meshes / bunny.file);
        CHECK(mesh.nodes.size() == bunny.nodes);
        CHECK(mesh.elements.size() == bunny.elements);
        CHECK_NOTHROW(check_solid(mesh, bunny.file));

        double volume = 0, angle = 4;
        for (const auto& e : mesh.elements) {
            const auto x = [&](std::size_t i) { return mesh.nodes[e[i]]; };
            volume += signed_volume({x(0), x(1), x(2), x(3)});
            angle = std::min(angle, smallest_dihedral_angle({x(0), x(1), x(2), x(3)}));
        }
        const SurfaceMesh surface = surface_of(mesh).mesh;
        CHECK(surface.faces.size() == bunny.faces);
        CHECK(with_edge_midpoints(mesh).nodes.size() == bunny.quadratic_nodes);
        CHECK(enclosed_volume(surface) == doctest::Approx(volume).epsilon(1e-12));
        CHECK(std::abs(volume - bunny.volume) < 0.05);
        CHECK(std::abs(angle * 180 / std::numbers::pi - bunny.angle_deg) < 0.05);
    }
}

TEST_CASE("OBJ reader: triangles, polygons, textures, negative numbers and stray vertices")
{
    std::istringstream stream(
        "# a cube\nmtllib none.mtl\no cube\n"
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.1 1e300 7\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
        "vt 0 0\nvn 0 0 1\ng sides\nusemtl red\n"
        "f 4/1/1 3/1/1 2/1/1 1/1/1\nf 6//1 7//1 8//1 9//1\nf 1 2 7 6\ns off\nf 2 3 8\nf 2 8 7\nf 3 4 9 8\nf 4 1 -4 -1\n");
    const SurfaceMesh cube = read_obj(stream, "text");
    CHECK(cube.vertices.size() == 8);
    CHECK(cube.faces.size() == 12);
    CHECK_NOTHROW(check_surface(cube, "text"));
    CHECK(enclosed_volume(cube) == doctest::Approx(1).epsilon(1e-14));
}

TEST_CASE("OBJ reader: a polygon with a dent is cut along its inside")
{
    std::istringstream stream("v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2 0\nf 1 2 3 4 5\n");
    const SurfaceMesh dented = read_obj(stream, "text");
    CHECK(dented.faces.size() == 3);
    double area = 0;
    for (const auto& [a, b, c] : dented.faces) {
        const auto x = [&](int v) { return dented.vertices[v]; };
        const double part = (x(b) - x(a)).cross(x(c) - x(a)).z() / 2;
        CHECK(part > 0);
        area += part;
    }
    CHECK(area == doctest::Approx(4 - 1.5).epsilon(1e-14));  // the square without its dent
}

TEST_CASE("OBJ reader: a polygon without an inside is refused with its line")
{
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 1 1 0\n";
    std::istringstream flat(corners + "f 1 2 5\nf 1 2 3 4\n"), twice(corners + "f 1 3 1 5\n");
    CHECK_THROWS_WITH_AS(read_obj(flat, "text"), "text:7: this polygon cannot be cut into triangles",
                         InputError);
    CHECK_THROWS_WITH_AS(read_obj(twice, "text"), "text:6: this polygon cannot be cut into triangles",
                         InputError);
}

TEST_CASE("OBJ reader: coordinates are the doubles nearest to their decimals")
{
    std::istringstream stream("v 0.1 0.30000000000000004 12345678.901234567\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    CHECK(read_obj(stream, "text").vertices[0] == Vec3(0.1, 0.30000000000000004, 12345678.901234567));
}
