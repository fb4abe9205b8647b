#include "common/geometry/surface_size.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <cmath>

using namespace enduring;

namespace {

double size_of(const SurfaceMesh& mesh)
{
    return surface_size(SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces), mesh.vertices);
}

}  // namespace

TEST_CASE("surface size: a cube has its edge, a ball its diameter, a thin plate three times its thickness")
{
    CHECK(size_of(box({2, 2, 2})) == doctest::Approx(2).epsilon(1e-14));
    CHECK(size_of(sphere(0.3, 5)) == doctest::Approx(0.6).epsilon(2e-3));
    CHECK(size_of(box({100, 0.01, 100})) == doctest::Approx(0.03).epsilon(1e-3));
}

TEST_CASE("surface size: it is the same however the body lies and is cut, and grows as its lengths do")
{
    SurfaceMesh fine = box({1, 2, 3}, {4, 5, 6});
    const double expected = 6 * 6.0 / 22;
    CHECK(size_of(box({1, 2, 3})) == doctest::Approx(expected).epsilon(1e-14));
    for (Vec3& x : fine.vertices)
        x = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()) * x + Vec3(50, -20, 7);
    CHECK(size_of(fine) == doctest::Approx(expected).epsilon(1e-12));
    for (Vec3& x : fine.vertices)
        x *= 1e-3;
    CHECK(size_of(fine) == doctest::Approx(1e-3 * expected).epsilon(1e-12));
}

TEST_CASE("surface size: what has a border is as large as the cube with its area, what has no area has none")
{
    CHECK(size_of(plane_grid(6, 4, {3, 2}, GridDiagonals::alternating)) == doctest::Approx(2).epsilon(1e-14));
    CHECK(surface_size(SurfaceTopology(1, {}), std::vector<Vec3>{Vec3::Zero()}) == 0);
}

TEST_CASE("surface size: points and edges alone are as large as the ball about their mean that holds them")
{
    const std::vector<Vec3> ends{{1, 1, 0}, {1, 4, 4}};
    CHECK(surface_size(SurfaceTopology::of_edges(2, {{0, 1}}), ends) == doctest::Approx(5));
    CHECK(surface_size(SurfaceTopology::of_edges(2, {}), ends) == doctest::Approx(5));
}
