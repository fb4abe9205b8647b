#include "common/geometry/surface_topology.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/input/input_error.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace enduring;

namespace {

bool same(std::span<const int> a, const std::vector<int>& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

}  // namespace

TEST_CASE("topology: every neighbourhood equals a search through all faces")
{
    for (const SurfaceMesh& mesh :
         {sphere(1, 2), plane_grid(1, 1, {4, 3}, GridDiagonals::crossed), box({1, 2, 3}, {2, 3, 4})}) {
        const SurfaceTopology surface = topology_of(mesh);
        for (int v = 0; v < surface.vertex_count(); ++v) {
            std::vector<int> faces, edges;
            for (int f = 0; f < static_cast<int>(mesh.faces.size()); ++f)
                if (const Face& face = mesh.faces[f]; std::count(face.begin(), face.end(), v))
                    faces.push_back(f);
            for (int e = 0; e < static_cast<int>(surface.edges().size()); ++e)
                if (const Edge& edge = surface.edges()[e]; edge[0] == v || edge[1] == v)
                    edges.push_back(e);
            CAPTURE(v);
            CHECK(same(surface.faces_around_vertex(v), faces));
            CHECK(same(surface.edges_around_vertex(v), edges));
        }
    }
}

TEST_CASE("topology: edges of a face and faces at an edge name each other, in order")
{
    const SurfaceTopology surface = topology_of(sphere(1, 1));
    for (int f = 0; f < static_cast<int>(surface.faces().size()); ++f)
        for (std::size_t i = 0; i < 3; ++i) {
            const Face& face = surface.faces()[f];
            const int e = surface.edges_of_face(f)[i];
            const Edge expected{std::min(face[i], face[(i + 1) % 3]), std::max(face[i], face[(i + 1) % 3])};
            CHECK(surface.edges()[e] == expected);
            const auto& [first, second] = surface.faces_at_edge(e);
            CHECK((first == f || second == f));
            CHECK(first < second);
        }
    CHECK(std::is_sorted(surface.edges().begin(), surface.edges().end()));
}

TEST_CASE("topology: closed surfaces obey Euler's formula")
{
    for (const SurfaceMesh& mesh : {sphere(1, 3), box({1, 1, 1}, {3, 2, 5}), tetrahedron(1), bowl({})}) {
        const SurfaceTopology surface = topology_of(mesh);
        CHECK(surface.is_closed());
        CHECK(surface.is_manifold());
        CHECK(surface.is_consistently_oriented());
        CHECK(surface.vertex_count() - static_cast<int>(surface.edges().size()) +
                  static_cast<int>(surface.faces().size()) ==
              2);
    }
}

TEST_CASE("topology: an open grid is manifold and oriented, but not closed")
{
    const SurfaceTopology surface = topology_of(plane_grid(1, 1, {2, 2}));
    CHECK_FALSE(surface.is_closed());
    CHECK(surface.is_manifold());
    CHECK(surface.is_consistently_oriented());
    const auto borders = std::count_if(surface.edges().begin(), surface.edges().end(), [&](const Edge& edge) {
        return surface.faces_at_edge(static_cast<int>(&edge - surface.edges().data()))[1] == -1;
    });
    CHECK(borders == 8);
}

TEST_CASE("topology: three faces at an edge are not manifold")
{
    const SurfaceTopology fin(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
    CHECK_FALSE(fin.is_manifold());
}

TEST_CASE("topology: two cones that touch in one vertex are not manifold")
{
    const SurfaceTopology bow_tie(5, {{0, 1, 2}, {0, 3, 4}});
    CHECK_FALSE(bow_tie.is_manifold());
    CHECK(bow_tie.is_consistently_oriented());
}

TEST_CASE("topology: a flipped face is noticed")
{
    SurfaceMesh mesh = box({1, 1, 1});
    std::swap(mesh.faces[3][0], mesh.faces[3][1]);
    const SurfaceTopology surface = topology_of(mesh);
    CHECK_FALSE(surface.is_consistently_oriented());
    CHECK(surface.is_manifold());
}

TEST_CASE("topology: faces with a vertex out of range or named twice are refused")
{
    CHECK_THROWS_AS(SurfaceTopology(3, {{0, 1, 3}}), InputError);
    CHECK_THROWS_AS(SurfaceTopology(3, {{0, -1, 2}}), InputError);
    CHECK_THROWS_AS(SurfaceTopology(3, {{0, 1, 1}}), InputError);
}

TEST_CASE("surface topology: points and edges alone know their neighbours, and are not closed")
{
    const SurfaceTopology frame = SurfaceTopology::of_edges(5, {{3, 1}, {0, 1}, {1, 2}});
    CHECK(frame.faces().empty());
    REQUIRE(frame.edges().size() == 3);
    CHECK(frame.edges()[0] == Edge{0, 1});
    CHECK(frame.edges()[2] == Edge{1, 3});
    CHECK(frame.edges_around_vertex(1).size() == 3);
    CHECK(frame.edges_around_vertex(4).empty());
    CHECK(frame.faces_around_vertex(1).empty());
    CHECK(frame.faces_at_edge(1) == std::array{-1, -1});
    CHECK_FALSE(frame.is_closed());
    CHECK_FALSE(SurfaceTopology::of_edges(3, {}).is_closed());
    CHECK_THROWS_AS(SurfaceTopology::of_edges(2, {{0, 2}}), InputError);
    CHECK_THROWS_AS(SurfaceTopology::of_edges(2, {{1, 1}}), InputError);
    CHECK_THROWS_AS(SurfaceTopology::of_edges(2, {{0, 1}, {1, 0}}), InputError);
}
