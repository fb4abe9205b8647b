#include "common/simulation/rest_neighbours.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/simulation/deformable_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace enduring;

namespace {

bool have_common_vertex(const Face& face, int vertex)
{
    return std::find(face.begin(), face.end(), vertex) != face.end();
}

/// Top and bottom of a thin plate of squares of 0.1 m.
SurfaceMesh plate(double thickness) { return box({1, thickness, 1}, {10, 1, 10}); }

int vertex_at(const SurfaceMesh& mesh, const Vec3& place)
{
    int nearest = 0;
    for (int i = 0; i < static_cast<int>(mesh.vertices.size()); ++i)
        if ((mesh.vertices[i] - place).norm() < (mesh.vertices[nearest] - place).norm())
            nearest = i;
    return nearest;
}

}  // namespace

TEST_CASE("rest neighbours: features with a common vertex are, and those of two sides of a block are not")
{
    const SurfaceMesh mesh = plate(0.5);
    const SurfaceTopology surface(static_cast<int>(mesh.vertices.size()), mesh.faces);
    const RestNeighbours neighbours(surface, mesh.vertices);
    const int top = vertex_at(mesh, {0, 0.25, 0}), below = vertex_at(mesh, {0, -0.25, 0});
    for (int face = 0; face < static_cast<int>(surface.faces().size()); ++face)
        if (have_common_vertex(surface.faces()[face], top)) {
            CHECK(neighbours.vertex_and_face(top, face));
            CHECK_FALSE(neighbours.vertex_and_face(below, face));
            for (const int edge : surface.edges_around_vertex(top))
                CHECK(neighbours.edge_and_face(edge, face));
            for (const int edge : surface.edges_around_vertex(below))
                CHECK_FALSE(neighbours.edge_and_face(edge, face));
        }
    for (const int edge : surface.edges_around_vertex(top)) {
        for (const int other : surface.edges_around_vertex(top))
            CHECK(neighbours.edges(edge, other));
        for (const int other : surface.edges_around_vertex(below))
            CHECK_FALSE(neighbours.edges(edge, other));
    }
}

TEST_CASE("rest neighbours: through a wall that is thinner than an edge is long they are neighbours, too")
{
    const SurfaceMesh mesh = plate(0.05);
    const SurfaceTopology surface(static_cast<int>(mesh.vertices.size()), mesh.faces);
    const RestNeighbours neighbours(surface, mesh.vertices);
    const int top = vertex_at(mesh, {0, 0.025, 0}), below = vertex_at(mesh, {0, -0.025, 0}),
              far = vertex_at(mesh, {0.4, -0.025, 0});
    for (const int face : surface.faces_around_vertex(top)) {
        CHECK(neighbours.vertex_and_face(below, face));
        CHECK_FALSE(neighbours.vertex_and_face(far, face));
    }
}

TEST_CASE(
    "rest neighbours: only a soft body that asks for it meets itself, in its rest shape wherever it lies")
{
    DeformableSettings settings;
    CHECK(rest_neighbours(DeformableBody("body", bar({1, 1, 1}, {4, 4, 4}), settings)) == nullptr);
    settings.self_contact = true;
    settings.position = {1, 2, 3};
    settings.rotation = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    const DeformableBody body("body", bar({1, 1, 1}, {4, 4, 4}), settings);
    const RestNeighbours* neighbours = rest_neighbours(body);
    REQUIRE(neighbours != nullptr);
    for (int face = 0; face < static_cast<int>(body.surface().faces().size()); ++face)
        CHECK(neighbours->vertex_and_face(body.surface().faces()[face][0], face));
    long apart = 0;
    for (int face = 0; face < static_cast<int>(body.surface().faces().size()); ++face)
        apart += !neighbours->vertex_and_face(0, face);
    CHECK(apart > static_cast<long>(body.surface().faces().size()) / 2);
}
