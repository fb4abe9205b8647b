#include "common/geometry/offset_surface.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"

#include <doctest/doctest.h>

using namespace enduring;

TEST_CASE("offset surface: outwards is where a ball grows, by the distance asked")
{
    const SurfaceMesh ball = sphere(1, 2);
    for (const double distance : {0.1, -0.1})
        for (const Vec3& x : offset_surface(ball.faces, ball.vertices, distance))
            CHECK(x.norm() == doctest::Approx(1 + distance).epsilon(1e-3));
}

TEST_CASE("offset surface: a face's own vertices move along its normal, and one without a face stays")
{
    const std::vector<Vec3> x{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {5, 5, 5}};
    const std::vector<Face> up{{0, 1, 2}};
    const std::vector<Vec3> moved = offset_surface(up, x, 0.25);
    for (int vertex = 0; vertex < 3; ++vertex)
        CHECK((moved[vertex] - x[vertex] - Vec3(0, 0.25, 0)).norm() < 1e-15);
    CHECK(moved[3] == x[3]);
}

TEST_CASE("offset surface: large faces pull a vertex' normal to theirs")
{
    const SurfaceMesh slab = box({1, 0.01, 1});
    const std::vector<Vec3> moved = offset_surface(slab.faces, slab.vertices, 1);
    for (std::size_t vertex = 0; vertex < moved.size(); ++vertex)
        CHECK(std::abs(moved[vertex].y() - slab.vertices[vertex].y()) > 0.99);
}
