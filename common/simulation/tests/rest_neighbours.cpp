#include "common/simulation/rest_neighbours.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/simulation/deformable_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace enduring;

namespace {

/// A body that meets itself, and where its vertices lie.
struct Solid {
    explicit Solid(const TetrahedralMesh& mesh) : body("solid", mesh, meeting_itself()) {}
    static DeformableSettings meeting_itself()
    {
        DeformableSettings settings;
        settings.self_contact = true;
        return settings;
    }
    const RestNeighbours& neighbours() const { return *rest_neighbours(body); }
    int vertex_at(const Vec3& place) const
    {
        const auto x = body.positions_t0();
        return static_cast<int>(std::min_element(x.begin(), x.end(),
                                                 [&](const Vec3& a, const Vec3& b) {
                                                     return (a - place).norm() < (b - place).norm();
                                                 }) -
                                x.begin());
    }
    DeformableBody body;
};

/// A plate of squares of 0.1 m, so many cells thick.
Solid plate(double thickness, int cells = 1) { return Solid(bar({1, thickness, 1}, {10, cells, 10})); }

}  // namespace

TEST_CASE("rest neighbours: features with a common vertex are, and those of two sides of a block are not")
{
    const Solid solid = plate(0.5);
    const SurfaceTopology& surface = solid.body.surface();
    const RestNeighbours& neighbours = solid.neighbours();
    const int top = solid.vertex_at({0, 0.25, 0}), below = solid.vertex_at({0, -0.25, 0});
    // the longest edges at a vertex lead down into the block, so its next neighbours are all
    for (const int face : surface.faces_around_vertex(top)) {
        CHECK(neighbours.vertex_and_face(top, face));
        for (const int edge : surface.edges_around_vertex(top))
            CHECK(neighbours.edge_and_face(edge, face));
        CHECK_FALSE(neighbours.vertex_and_face(below, face));
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
    for (const int cells : {1, 2}) {
        const Solid solid = plate(0.05, cells);
        const int top = solid.vertex_at({0, 0.025, 0}), below = solid.vertex_at({0, -0.025, 0}),
                  far = solid.vertex_at({0.4, -0.025, 0});
        for (const int face : solid.body.surface().faces_around_vertex(top)) {
            CHECK(solid.neighbours().vertex_and_face(below, face));
            CHECK_FALSE(solid.neighbours().vertex_and_face(far, face));
        }
    }
}

TEST_CASE("rest neighbours: what is near through the air only is none")
{
    // a plate that is bent to two walls, which are nearer to each other than an edge is long
    TetrahedralMesh mesh = bar({1, 0.05, 0.3}, {10, 1, 3});
    for (Vec3& x : mesh.nodes)
        if (std::abs(x.x()) > 0.05)
            x = Vec3(x.x() < 0 ? x.y() - 0.06 : 0.06 - x.y(), std::abs(x.x()), x.z());
    const Solid solid(mesh);
    const int left = solid.vertex_at({-0.035, 0.5, 0.05}), right = solid.vertex_at({0.035, 0.5, 0.05});
    for (const int face : solid.body.surface().faces_around_vertex(left))
        CHECK_FALSE(solid.neighbours().vertex_and_face(right, face));
    const int outside = solid.vertex_at({-0.085, 0.5, 0.05});
    for (const int face : solid.body.surface().faces_around_vertex(left))
        CHECK(solid.neighbours().vertex_and_face(outside, face));
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
