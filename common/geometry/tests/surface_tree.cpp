#include "common/geometry/surface_tree.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/geometry/triangle_distance.hpp"
#include "common/geometry/winding_number.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace enduring;

namespace {

std::vector<Vec3> random_points(int count, unsigned seed, double reach)
{
    std::mt19937_64 generator(seed);
    std::uniform_real_distribution<double> unit(-reach, reach);
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        const double x = unit(generator), y = unit(generator), z = unit(generator);
        points.emplace_back(x, y, z);
    }
    return points;
}

}  // namespace

TEST_CASE("surface tree: what it holds and how far its faces are is what the solid angle and every face say")
{
    BowlShape bowl_shape;
    for (const SurfaceMesh& mesh :
         {box({1, 0.8, 1.2}, {3, 2, 1}), sphere(0.7, 2), bowl(bowl_shape), tetrahedron(1)}) {
        const SurfaceTree tree(mesh.faces, mesh.vertices);
        int inside = 0;
        for (const Vec3& point : random_points(800, 17, 1.3)) {
            CAPTURE(point.transpose());
            double nearest = 1e300;
            for (const auto& [a, b, c] : mesh.faces)
                nearest = std::min(nearest, distance_to_triangle(point, mesh.vertices[a], mesh.vertices[b],
                                                                 mesh.vertices[c]));
            CHECK(tree.distance(point) == doctest::Approx(nearest).epsilon(1e-12));
            CHECK(tree.contains(point) == (winding_number(mesh.faces, mesh.vertices, point) > 0.5));
            inside += tree.contains(point);
        }
        CHECK(inside > 5);
    }
}

TEST_CASE(
    "surface tree: of the points of a grid in a box none lies on the wrong side, though many face its edges")
{
    const SurfaceMesh mesh = box({2, 2, 2}, {4, 4, 4});
    const SurfaceTree tree(mesh.faces, mesh.vertices);
    for (int i = -5; i <= 5; ++i)
        for (int j = -5; j <= 5; ++j)
            for (int k = -5; k <= 5; ++k) {
                const Vec3 point = 0.25 * Vec3(i, j, k);
                if (const double largest = point.cwiseAbs().maxCoeff(); largest != 1)
                    CHECK(tree.contains(point) == (largest < 1));
            }
}

TEST_CASE("surface tree: a segment passes an open floor downwards, not upwards, and not beside it")
{
    const SurfaceMesh floor = plane_grid(2, 2, {3, 3});
    const SurfaceTree tree(floor.faces, floor.vertices);
    CHECK(tree.is_passed({0.1, 0.2, 0.3}, {0.15, -0.1, 0.3}));
    CHECK_FALSE(tree.is_passed({0.15, -0.1, 0.3}, {0.1, 0.2, 0.3}));
    CHECK_FALSE(tree.is_passed({0.1, 0.2, 0.3}, {0.15, 0.1, 0.3}));
    CHECK_FALSE(tree.is_passed({1.1, 0.2, 0.3}, {1.1, -0.1, 0.3}));
}
