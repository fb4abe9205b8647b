#include "chapters/05_categorisation/experiments/corner.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace enduring;
using namespace enduring::chapter05;

namespace {

/// Two triangles that hinge on the edge from vertex 0 to 1 along z, each
/// leaning down by an angle from the plane y = 0.
Corner hinge(double angle)
{
    Corner corner;
    corner.positions = {{0, 0, 0},
                        {0, 0, 1},
                        {std::cos(angle), -std::sin(angle), 0.5},
                        {-std::cos(angle), -std::sin(angle), 0.5}};
    corner.topology = SurfaceTopology(4, {{0, 1, 2}, {1, 0, 3}});
    return corner;
}

int edge_between(const SurfaceTopology& topology, int a, int b)
{
    for (int edge = 0; edge < static_cast<int>(topology.edges().size()); ++edge)
        if (topology.edges()[edge] == Edge{a, b})
            return edge;
    return -1;
}

}  // namespace

TEST_CASE("normal span: a cube's corner has the three directions of its sides, and their average last")
{
    // the solid lies where all are positive
    const Corner corner = fan("corner", {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}});
    const std::vector<Vec3> normals = normal_span(corner.surface(), corner.faces());
    REQUIRE(normals.size() == 4);
    Vec3 sum = Vec3::Zero();
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 expected = -Vec3::Unit(axis);
        CAPTURE(axis);
        CHECK(std::count_if(normals.begin(), normals.end(),
                            [&](const Vec3& n) { return (n - expected).norm() < 1e-15; }) == 1);
        sum += expected;
    }
    CHECK((normals.back() - sum / std::sqrt(3.0)).norm() < 1e-15);
}

TEST_CASE("normal span: an edge has the normals of its two faces and what lies halfway between")
{
    for (const double angle : {0.0, 0.3, 1.2}) {
        CAPTURE(angle);
        Corner fold = hinge(angle);
        fold.positions[2] *= 7;  // a large face and a small one: each counts alike
        const int edge = edge_between(fold.topology, 0, 1);
        const std::vector<Vec3> normals = normal_span(fold.surface(), fold.topology.faces_at_edge(edge));
        REQUIRE(normals.size() == 3);
        CHECK((normals[0] - Vec3(std::sin(angle), std::cos(angle), 0)).norm() < 1e-15);
        CHECK((normals[1] - Vec3(-std::sin(angle), std::cos(angle), 0)).norm() < 1e-15);
        CHECK((normals[2] - Vec3::UnitY()).norm() < 1e-15);
    }
}

TEST_CASE("normal span: on a border there is one face and its normal stands for all")
{
    const Corner fold = hinge(0.4);
    const Vec3 expected(std::sin(0.4), std::cos(0.4), 0);
    for (const Vec3& normal :
         normal_span(fold.surface(), fold.topology.faces_at_edge(edge_between(fold.topology, 0, 2))))
        CHECK((normal - expected).norm() < 1e-15);
    CHECK(normal_span(fold.surface(), fold.topology.faces_around_vertex(2)).size() == 2);
}

TEST_CASE("normal span: faces without area say nothing, and opposite faces have no average")
{
    Corner needle = hinge(0.4);
    needle.positions[3] = needle.positions[0];  // the second face collapses
    CHECK(normal_span(needle.surface(), needle.topology.faces_at_edge(edge_between(needle.topology, 0, 1)))
              .size() == 2);

    const Corner sheet = hinge(std::numbers::pi / 2);  // both faces hang down, back to back
    const std::vector<Vec3> two_sides = normal_span(
        sheet.surface(), sheet.topology.faces_at_edge(edge_between(sheet.topology, 0, 1)));
    REQUIRE(two_sides.size() == 2);
    CHECK((two_sides[0] + two_sides[1]).norm() < 1e-15);
}

TEST_CASE("normal span: a vertex without faces reaches every direction")
{
    const std::vector<Vec3> points{Vec3::Zero()};
    const SurfaceTopology lone(1, {});
    const SurfaceMoment surface{{lone, points, points}, 0};
    for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(-0.3, 2, 0.1), Vec3(0, 0, -1e-6)})
        CHECK(span_reaches(surface, lone.faces_around_vertex(0), direction, 0.999));
}

TEST_CASE("normal span: between the ends of a step the faces are those of vertices on straight lines")
{
    const Corner start = hinge(0.2);
    std::vector<Vec3> end = start.positions;
    end[2] += Vec3(0.1, 0.5, 0.2);
    end[3] += Vec3(0.3, -0.4, 0.1);
    for (const double tau : {0.25, 0.5, 1.0}) {
        CAPTURE(tau);
        Corner between = start;
        for (std::size_t v = 0; v < end.size(); ++v)
            between.positions[v] = start.positions[v] + tau * (end[v] - start.positions[v]);
        const SurfaceMoment moment{{start.topology, start.positions, end}, tau};
        for (const int face : {0, 1})
            CHECK((moment.face_normal(face) - between.surface().face_normal(face)).norm() < 1e-15);
    }
}
