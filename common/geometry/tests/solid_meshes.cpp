#include "common/geometry/element_quality.hpp"
#include "common/geometry/quadratic.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/geometry/surface_extraction.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"

#include <doctest/doctest.h>

using namespace enduring;

namespace {

double volume_of(const TetrahedralMesh& mesh)
{
    double volume = 0;
    for (const auto& e : mesh.elements) {
        const auto x = [&](std::size_t i) { return mesh.nodes[e[i]]; };
        const double part = signed_volume({x(0), x(1), x(2), x(3)});
        CHECK(part > 0);
        volume += part;
    }
    return volume;
}

/// Divergence theorem: a sixth of the sum of a . (b x c) over the faces.
double enclosed(const SurfaceMesh& mesh)
{
    double sum = 0;
    for (const auto& [a, b, c] : mesh.faces)
        sum += mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c]));
    return sum / 6;
}

bool closed_manifold(const SurfaceMesh& mesh)
{
    const SurfaceTopology surface(static_cast<int>(mesh.vertices.size()), mesh.faces);
    return surface.is_closed() && surface.is_manifold() && surface.is_consistently_oriented();
}

}  // namespace

TEST_CASE("bar: both splits fill the cuboid, and neighbouring cells agree on their diagonals")
{
    for (CellSplit split : {CellSplit::six, CellSplit::five}) {
        const TetrahedralMesh mesh = bar({3, 1, 2}, {5, 3, 4}, split);
        CAPTURE(split);
        CHECK(volume_of(mesh) == doctest::Approx(6.0).epsilon(1e-13));
        CHECK(mesh.elements.size() == 60 * (split == CellSplit::six ? 6 : 5));
        // Diagonals that disagree would leave inner faces missed_vertices, and so more faces on the surface.
        const ExtractedSurface surface = surface_of(mesh);
        CHECK(surface.mesh.faces.size() == 2 * 2 * (5 * 3 + 3 * 4 + 4 * 5));
        CHECK(closed_manifold(surface.mesh));
        CHECK(enclosed(surface.mesh) == doctest::Approx(6.0).epsilon(1e-13));
        CHECK(faces_of_three_elements(mesh).empty());
    }
}

TEST_CASE("surface extraction: each vertex is the node that the map names")
{
    const TetrahedralMesh mesh = bar({1, 1, 1}, {2, 2, 2});
    const ExtractedSurface surface = surface_of(mesh);
    CHECK(surface.nodes.size() == 26);  // all of the 27 nodes but the middle one
    for (std::size_t v = 0; v < surface.nodes.size(); ++v)
        CHECK(surface.mesh.vertices[v] == mesh.nodes[surface.nodes[v]]);
}

TEST_CASE("surface extraction: a 10-node face becomes four triangles with the same outline")
{
    const TetrahedralMesh linear = bar({3, 1, 2}, {3, 1, 2}, CellSplit::five);
    const QuadraticTetrahedralMesh quadratic = with_edge_midpoints(linear);
    const ExtractedSurface coarse = surface_of(linear), fine = surface_of(quadratic);
    CHECK(fine.mesh.faces.size() == 4 * coarse.mesh.faces.size());
    CHECK(closed_manifold(fine.mesh));
    CHECK(enclosed(fine.mesh) == doctest::Approx(6.0).epsilon(1e-13));
    for (std::size_t v = 0; v < fine.nodes.size(); ++v)
        CHECK(fine.mesh.vertices[v] == quadratic.nodes[fine.nodes[v]]);

    // Every fourth triangle is the middle one; all four have a quarter of the whole triangle's area.
    const auto area = [](const SurfaceMesh& mesh, std::size_t face) {
        const auto& [a, b, c] = mesh.faces[face];
        const Vec3& origin = mesh.vertices[a];
        return (mesh.vertices[b] - origin).cross(mesh.vertices[c] - origin).norm() / 2;
    };
    for (std::size_t f = 0; f < fine.mesh.faces.size(); ++f)
        CHECK(area(fine.mesh, f) == doctest::Approx(area(coarse.mesh, f / 4) / 4).epsilon(1e-12));
}

TEST_CASE("quadratic mesh: each edge has one node, in its middle, shared by all elements around it")
{
    const TetrahedralMesh linear = bar({1, 1, 1}, {2, 1, 1});
    const QuadraticTetrahedralMesh mesh = with_edge_midpoints(linear);
    CHECK(mesh.corner_count == 12);
    // Edges counted by hand: along the axes 8 + 6 + 6, diagonals of
    // faces 4 (xy) + 4 (xz) + 3 (yz), of cells none.
    CHECK(mesh.nodes.size() == 12 + 20 + 11);
    for (const auto& element : mesh.elements)
        for (std::size_t e = 0; e < 6; ++e) {
            const auto node = [&](int local) { return mesh.nodes[element[static_cast<std::size_t>(local)]]; };
            const Vec3 middle = 0.5 * (node(tetrahedron_edges[e][0]) + node(tetrahedron_edges[e][1]));
            CHECK((node(static_cast<int>(4 + e)) - middle).norm() == 0.0);
        }
    CHECK(corners_of(mesh).elements == linear.elements);
}

TEST_CASE("element quality: volume and dihedral angles of the regular tetrahedron")
{
    const SurfaceMesh regular = tetrahedron(2);
    const std::array<Vec3, 4> inverted{regular.vertices[0], regular.vertices[1], regular.vertices[2],
                                       regular.vertices[3]};
    const std::array<Vec3, 4> upright{inverted[0], inverted[2], inverted[1], inverted[3]};
    CHECK(signed_volume(upright) == doctest::Approx(8 / (6 * std::sqrt(2.0))).epsilon(1e-13));
    CHECK(smallest_dihedral_angle(upright) == doctest::Approx(std::acos(1.0 / 3)).epsilon(1e-13));
    CHECK(element_fault(upright).empty());
    CHECK(element_fault(inverted).find("inverted") != std::string::npos);
}

TEST_CASE("element quality: a flat element and an overbent one are faults")
{
    CHECK(element_fault(std::array<Vec3, 4>{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 1e-16)})
              .find("flat") != std::string::npos);

    QuadraticTetrahedralMesh mesh =
        with_edge_midpoints({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}});
    std::array<Vec3, 10> nodes;
    const auto fault = [&] {
        for (std::size_t i = 0; i < 10; ++i)
            nodes[i] = mesh.nodes[mesh.elements[0][i]];
        return element_fault(nodes);
    };
    CHECK(fault().empty());
    Vec3& middle_of_first_edge = mesh.nodes[mesh.elements[0][4]];
    middle_of_first_edge = {0.7, 0, 0};
    CHECK(fault().empty());
    middle_of_first_edge = {0.8, 0, 0};  // past three quarters the map runs backwards at the far corner
    CHECK(fault().find("curved") != std::string::npos);
}
