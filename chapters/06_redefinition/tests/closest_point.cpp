#include "chapters/06_redefinition/baseline/closest_point.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/geometry/winding_number.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace enduring;

namespace {

struct Random {
    std::mt19937_64 generator{7};
    double operator()(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(generator);
    }
    Vec3 vector(double size) { return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)}; }
};

struct Surface {
    explicit Surface(const SurfaceMesh& mesh)
        : positions(mesh.vertices), topology(static_cast<int>(mesh.vertices.size()), mesh.faces),
          tree(topology, positions)
    {
        tree.refit({topology, positions, positions});
    }
    ClosestPoint closest(const Vec3& p, double within = 1e300) const
    {
        return closest_point(tree, topology, positions, p, within);
    }
    bool has_inside(const Vec3& p) const
    {
        const ClosestPoint closest = this->closest(p);
        return pseudonormal(topology, positions, closest).dot(p - closest.point) < 0;
    }
    std::vector<Vec3> positions;
    SurfaceTopology topology;
    FaceTree tree;
};

/// A sharp tetrahedron with one of its sides cut into thin faces: a
/// plain sum of normals would follow their number.
SurfaceMesh fanned_spike()
{
    const int cuts = 12;
    SurfaceMesh spike{{{0, 1, 0}, {0, 0, -0.5}}, {}};
    for (int i = 0; i <= cuts; ++i)
        spike.vertices.push_back({-0.2 + 0.4 * i / cuts, 0, 0});
    for (int i = 2; i < cuts + 2; ++i) {
        spike.faces.push_back({0, i, i + 1});
        spike.faces.push_back({1, i + 1, i});
    }
    spike.faces.push_back({0, cuts + 2, 1});
    spike.faces.push_back({0, 1, 2});
    return spike;
}

}  // namespace

TEST_CASE(
    "closest point: no corner of the triangle lies on the far side of the plane through it, square to the way there")
{
    // The triangle is convex, so this is necessary and sufficient: (p -
    // q) . (x - q) <= 0 for all of its corners x.
    Random random;
    std::array<int, 4> zeros{};
    for (int i = 0; i < 20000; ++i) {
        CAPTURE(i);
        const Vec3 a = random.vector(1), b = random.vector(1),
                   c = i % 4 ? random.vector(1) : Vec3(0.9 * b + 0.1 * a + random.vector(0.02));
        const Vec3 p = random.vector(2);
        const FaceWeights w = closest_weights(p, a, b, c);
        const Vec3 q = w[0] * a + w[1] * b + w[2] * c;
        REQUIRE(w[0] + w[1] + w[2] == doctest::Approx(1).epsilon(1e-12));
        for (const double weight : w)
            REQUIRE(weight >= 0);
        for (const Vec3& corner : {a, b, c})
            REQUIRE((p - q).dot(corner - q) <= 1e-12);
        ++zeros[(w[0] == 0) + (w[1] == 0) + (w[2] == 0)];
    }
    CHECK(zeros[0] > 500);  // inside, on edges and at corners
    CHECK(zeros[1] > 500);
    CHECK(zeros[2] > 500);
}

TEST_CASE(
    "closest point: the tree finds what looking at every face finds, and nothing beyond the asked distance")
{
    const Surface surface(bowl({}));
    Random random;
    for (int i = 0; i < 500; ++i) {
        CAPTURE(i);
        const Vec3 p = random.vector(1.3);
        double nearest = 1e300;
        for (const auto& [a, b, c] : surface.topology.faces()) {
            const Vec3 &x = surface.positions[a], &y = surface.positions[b], &z = surface.positions[c];
            const FaceWeights w = closest_weights(p, x, y, z);
            nearest = std::min(nearest, (p - w[0] * x - w[1] * y - w[2] * z).squaredNorm());
        }
        CHECK(surface.closest(p).squared_distance == doctest::Approx(nearest).epsilon(1e-12));
        CHECK(surface.closest(p, 1.01 * std::sqrt(nearest)).squared_distance ==
              doctest::Approx(nearest).epsilon(1e-12));
        CHECK(surface.closest(p, 0.99 * std::sqrt(nearest)).face == -1);
    }
}

TEST_CASE("closest point: in a box the depth is the distance to the nearest side")
{
    const Surface surface(box({2, 1, 3}, {3, 2, 4}));
    Random random;
    for (int i = 0; i < 500; ++i) {
        const Vec3 p(random(-1, 1), random(-0.5, 0.5), random(-1.5, 1.5));
        CAPTURE(p.transpose());
        const double depth = (Vec3(1, 0.5, 1.5) - p.cwiseAbs()).minCoeff();
        CHECK(std::sqrt(surface.closest(p).squared_distance) == doctest::Approx(depth).epsilon(1e-12));
        CHECK(surface.has_inside(p));
    }
}

TEST_CASE("closest point: in a fine sphere the depth is radius minus distance, and the way out is radial")
{
    const Surface surface(sphere(1.0, 4));
    Random random;
    for (int i = 0; i < 300; ++i) {
        const Vec3 direction = random.vector(1).normalized();
        const double radius = random(0.3, 1.7);
        CAPTURE(radius);
        const ClosestPoint closest = surface.closest(radius * direction);
        // the facets' height
        CHECK(std::abs(std::sqrt(closest.squared_distance) - std::abs(1 - radius)) < 0.004);
        CHECK(closest.point.normalized().dot(direction) > 0.995);
        if (std::abs(1 - radius) > 0.004)
            CHECK(surface.has_inside(radius * direction) == (radius < 1));
    }
}

TEST_CASE(
    "closest point: the pseudonormal tells inside from outside as the winding number does, at sharp and hollow corners too")
{
    std::vector<SurfaceMesh> meshes{bowl({.segments_around = 12, .segments_along = 5, .segments_rim = 2}),
                                    box({1, 1, 1}), fanned_spike()};
    Random random;
    for (const SurfaceMesh& mesh : meshes) {
        const Surface surface(mesh);
        REQUIRE(surface.topology.is_closed());
        REQUIRE(surface.topology.is_consistently_oriented());
        int inside = 0;
        for (int i = 0; i < 3000; ++i) {
            const Vec3 near = mesh.vertices[static_cast<std::size_t>(i) % mesh.vertices.size()];
            const Vec3 p = near + random.vector(i % 2 ? 0.3 : 0.02);
            CAPTURE(p.transpose());
            const double winding = winding_number(surface.topology.faces(), surface.positions, p);
            inside += winding > 0.5;
            REQUIRE(surface.has_inside(p) == (winding > 0.5));
        }
        CHECK(inside > 100);
    }
}

TEST_CASE("closest point: a sheet has an inside below it, and none beyond its border")
{
    const Surface sheet(plane_grid(2, 2, {2, 2}));
    CHECK(sheet.has_inside({0.3, -0.2, 0.1}));
    CHECK_FALSE(sheet.has_inside({0.3, 0.2, 0.1}));
    CHECK_FALSE(sheet.has_inside({1.1, -0.2, 0.1}));
    CHECK_FALSE(sheet.has_inside({1.1, -0.2, 1.1}));
}
