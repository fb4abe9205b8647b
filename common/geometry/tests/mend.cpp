#include "common/geometry/mend.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/moved_mesh.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/geometry/tests/complaint.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace enduring;

namespace {

/// Both in one mesh, with one vertex for those at the same place.
SurfaceMesh together(const SurfaceMesh& one, const SurfaceMesh& other)
{
    SurfaceMesh all = one;
    std::vector<int> place;
    for (const Vec3& x : other.vertices) {
        const auto same = std::find_if(all.vertices.begin(), all.vertices.end(),
                                       [&](const Vec3& y) { return (x - y).norm() < 1e-9; });
        place.push_back(static_cast<int>(same - all.vertices.begin()));
        if (same == all.vertices.end())
            all.vertices.push_back(Vec3(x));
    }
    for (const Face& face : other.faces)
        all.faces.push_back({place[face[0]], place[face[1]], place[face[2]]});
    return all;
}

std::string complaint(const SurfaceMesh& mesh)
{
    return complaint_of([&] { check_surface(mesh, "mesh"); });
}

/// Refused before, sound afterwards, with this volume.
MendCounts check_mended(const SurfaceMesh& mesh, double volume)
{
    CHECK(complaint(mesh) != "no complaint");
    const MendedSurface result = mended(mesh, Border::refused);
    CHECK(complaint(result.mesh) == "no complaint");
    CHECK(enclosed_volume(result.mesh) == doctest::Approx(volume).epsilon(1e-9));
    return result.counts;
}

const SurfaceMesh cube = box({1, 1, 1});

}  // namespace

TEST_CASE("mend: a sound surface stays as it is, to the last vertex")
{
    for (const SurfaceMesh& mesh : {cube, sphere(1, 2)}) {
        const MendedSurface result = mended(mesh, Border::refused);
        CHECK(result.counts.text().empty());
        CHECK(result.mesh.faces == mesh.faces);
        CHECK(result.mesh.vertices == mesh.vertices);
    }
}

TEST_CASE("mend: a face given twice is taken out once, whichever way the second one faces")
{
    SurfaceMesh twice = cube;
    twice.faces.push_back({twice.faces[3][1], twice.faces[3][2], twice.faces[3][0]});
    CHECK(check_mended(twice, 1).double_faces == 1);
    twice.faces.push_back({twice.faces[3][1], twice.faces[3][0], twice.faces[3][2]});
    CHECK(check_mended(twice, 1).double_faces == 2);
}

TEST_CASE("mend: a wall between two rooms has no inside on any side, and both of its layers go")
{
    const SurfaceMesh rooms = together(cube, moved(cube, {1, 0, 0}));
    REQUIRE(rooms.vertices.size() == 12);
    CHECK(check_mended(rooms, 2).double_faces == 4);
}

TEST_CASE("mend: parts that share an edge or a vertex get their own, and each keeps its inside")
{
    const MendCounts edge = check_mended(together(cube, moved(cube, {1, 1, 0})), 2);
    CHECK(edge.parted_edges == 1);
    CHECK(edge.parted_vertices == 2);
    const MendCounts corner = check_mended(together(cube, moved(cube, {1, 1, 1})), 2);
    CHECK(corner.parted_edges == 0);
    CHECK(corner.parted_vertices == 1);
    CHECK(corner.text() == "1 vertex more, where parts met");
    // four cubes around one edge, of which two opposite ones are there: the same in any order of faces
    SurfaceMesh turned = together(cube, moved(cube, {1, 1, 0}));
    std::reverse(turned.faces.begin(), turned.faces.end());
    CHECK(check_mended(turned, 2).parted_edges == 1);
}

TEST_CASE("mend: a flap is taken out, outside of the body and inside of it, with all of its faces")
{
    for (const double height : {3.0, -0.5}) {  // of its tip: outside, and inside the cube
        SurfaceMesh flap = cube;
        const auto [a, b, c] = cube.faces[0];
        const Vec3 middle = (cube.vertices[a] + cube.vertices[b]) / 2;
        flap.vertices.push_back(Vec3((1 + height) * middle));
        flap.vertices.push_back(Vec3((1.5 + height) * middle + Vec3(0.1, 0.2, 0.3)));
        flap.faces.push_back({a, b, 8});
        flap.faces.push_back({8, b, 9});
        const MendCounts counts = check_mended(flap, 1);
        CHECK(counts.flap_faces == 2);
        CHECK(counts.text() == "2 faces of flaps taken out");
    }
}

TEST_CASE("mend: a corner in the middle of a side cuts the neighbour there, and no crack is left")
{
    SurfaceMesh flat = cube;
    const auto [a, b, c] = flat.faces[0];
    flat.vertices.push_back(Vec3(0.3 * flat.vertices[a] + 0.7 * flat.vertices[b]));
    flat.faces[0] = {a, 8, c};
    flat.faces.push_back({8, b, c});
    flat.faces.push_back({a, b, 8});  // closes the crack with a face without area
    const MendCounts counts = check_mended(flat, 1);
    CHECK(counts.flat_faces == 1);
    CHECK(counts.text() == "1 face without area taken out");
}

TEST_CASE("mend: two corners that nearly coincide become one")
{
    SurfaceMesh needle = cube;
    const auto [a, b, c] = needle.faces[0];
    const auto beside = std::find_if(needle.faces.begin() + 1, needle.faces.end(), [&](const Face& face) {
        return std::count(face.begin(), face.end(), a) + std::count(face.begin(), face.end(), b) == 2;
    });
    REQUIRE(beside != needle.faces.end());
    needle.vertices.push_back(Vec3(needle.vertices[a] + Vec3(1e-13, 0, 0)));
    std::replace(needle.faces[0].begin(), needle.faces[0].end(), a, 8);
    needle.faces.push_back({a, b, 8});
    needle.faces.push_back({a, 8, c});
    CHECK(check_mended(needle, 1).flat_faces == 2);
}

TEST_CASE("mend: what an open surface carries stays, and holes are left for the check to tell")
{
    SurfaceMesh terrain = plane_grid(2, 2, {2, 2}, GridDiagonals::same);
    const std::size_t faces = terrain.faces.size();
    terrain.vertices.push_back(Vec3(0, 1, 0));
    const SurfaceTopology topology(static_cast<int>(terrain.vertices.size()), terrain.faces);
    std::size_t edge = 0;  // the first one of two faces
    while (topology.faces_at_edge(static_cast<int>(edge))[1] < 0)
        ++edge;
    const auto [a, b] = topology.edges()[edge];
    terrain.faces.push_back({a, b, static_cast<int>(terrain.vertices.size()) - 1});
    const MendedSurface kept = mended(terrain, Border::allowed);
    CHECK(kept.mesh.faces.size() == faces + 1);
    CHECK(complaint_of([&] { check_surface(kept.mesh, "mesh", Border::allowed); }) == "no complaint");
    SurfaceMesh open = cube;
    open.faces.pop_back();
    CHECK(complaint(mended(open, Border::refused).mesh).find("mesh: the surface is not closed") == 0);
}
