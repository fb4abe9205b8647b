#include "common/fem/point_weights.hpp"

#include "common/geometry/quadratic.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"

#include <doctest/doctest.h>

using namespace enduring;

TEST_CASE("point weights: they give the point back, and in a quadratic element a square, too")
{
    const TetrahedralMesh corners = bar({1, 2, 3}, {2, 2, 2});
    const ElasticMesh linear(corners), quadratic(with_edge_midpoints(corners));
    for (const Vec3& point : {Vec3(0.1, 0.7, -1.2), Vec3(0.5, 1, 1.5), Vec3(-0.5, 0.3, 0.2), Vec3(0, 0, 0)})
        for (const ElasticMesh* mesh : {&linear, &quadratic}) {
            CAPTURE(point.transpose());
            const std::vector<NodeWeight> weights = point_weights(*mesh, point);
            REQUIRE(!weights.empty());
            double sum = 0;
            Vec3 back = Vec3::Zero();
            for (const auto& [node, weight] : weights) {
                CHECK(weight > -1e-12);
                sum += weight;
                back += weight * mesh->rest().col(node);
            }
            CHECK(sum == doctest::Approx(1));
            CHECK((back - point).norm() < 1e-12);
        }
    // the control points of x^2 are x_i x_j
    double square = 0;
    const Vec3 point(0.1, 0.7, -1.2);
    for (const auto& [node, weight] : point_weights(quadratic, point)) {
        const auto& x = quadratic.rest();
        double control = x(0, node) * x(0, node);
        for (const ElasticElement& element : quadratic.elements())
            for (std::size_t e = 0; e < 6; ++e)
                if (element.nodes[4 + e] == node)
                    control = x(0, element.nodes[static_cast<std::size_t>(tetrahedron_edges[e][0])]) *
                              x(0, element.nodes[static_cast<std::size_t>(tetrahedron_edges[e][1])]);
        square += weight * control;
    }
    CHECK(square == doctest::Approx(0.01));
}

TEST_CASE("point weights: outside of the body there are none, but rounding is not outside")
{
    const ElasticMesh mesh(bar({1, 1, 1}, {1, 1, 1}));
    CHECK(point_weights(mesh, {0.5 + 1e-9, 0.2, 0}).size() == 4);
    CHECK(point_weights(mesh, {0.51, 0.2, 0}).empty());
    CHECK(point_weights(mesh, {7, 7, 7}).empty());
}
