#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/geometry/surface_checks.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/input/input_error.hpp"

#include <doctest/doctest.h>

#include <numbers>

using namespace enduring;
using std::numbers::pi;

namespace {

/// Volume between two regular polygons of n corners at heights h apart, with the corners above each other.
double frustum(double r1, double r2, double height, int n)
{
    return n / 2.0 * std::sin(2 * pi / n) * height * (r1 * r1 + r1 * r2 + r2 * r2) / 3;
}

/// Volume that the sphere of this radius holds below a plane, faceted as the bowl's wall is: sums of frusta
/// from the angle `from` to `to`, seen from the centre, straight down being 0.
double faceted_sphere_part(double radius, double from, double to, int along, int around)
{
    double volume = 0;
    for (int i = 0; i < along; ++i) {
        const double a = from + (to - from) * i / along, b = from + (to - from) * (i + 1) / along;
        volume += frustum(radius * std::sin(a), radius * std::sin(b), radius * (std::cos(a) - std::cos(b)),
                          around);
    }
    return volume;
}

}  // namespace

TEST_CASE("shapes: every closed shape is closed, manifold and faces outwards")
{
    for (const SurfaceMesh& mesh :
         {box({1, 2, 3}), box({1, 2, 3}, {4, 1, 2}), slope({4, 0.5, 2}, 0.3, {5, 1, 2}), tetrahedron(1),
          sphere(2, 0), sphere(2, 3), torus(1, 0.3), torus(2, 0.5, 5, 3), bowl({}),
          bowl({.rim_angle = 0.8, .foot_radius = 0.3, .segments_around = 7})})
        CHECK_NOTHROW(check_surface(mesh, "shape"));
}

TEST_CASE("shapes: a box has its size, its centre and its number of cells")
{
    const SurfaceMesh mesh = box({1, 2, 3}, {4, 1, 2});
    CHECK(enclosed_volume(mesh) == doctest::Approx(6).epsilon(1e-14));
    CHECK(mesh.faces.size() == 2 * 2 * (4 * 1 + 1 * 2 + 2 * 4));
    Eigen::AlignedBox3d bounds;
    for (const Vec3& x : mesh.vertices)
        bounds.extend(x);
    CHECK(bounds.center().norm() == 0);
    CHECK(bounds.sizes() == Vec3(1, 2, 3));
}

TEST_CASE("shapes: a slope holds its volume and rises towards +x at its angle, through the origin")
{
    const double angle = 0.3;
    const SurfaceMesh mesh = slope({4, 0.5, 2}, angle);
    CHECK(enclosed_volume(mesh) == doctest::Approx(4).epsilon(1e-14));
    const Vec3 out(-std::sin(angle), std::cos(angle), 0);
    int on_top = 0;
    for (const Vec3& x : mesh.vertices) {
        CHECK(out.dot(x) <= 1e-15);
        on_top += std::abs(out.dot(x)) < 1e-15;
    }
    CHECK(on_top == 4);
}

TEST_CASE("shapes: a tetrahedron has equal edges and the volume a^3 / (6 sqrt 2)")
{
    const SurfaceMesh mesh = tetrahedron(0.7);
    CHECK(enclosed_volume(mesh) == doctest::Approx(0.343 / (6 * std::sqrt(2.0))).epsilon(1e-13));
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
        sum += mesh.vertices[i];
        for (std::size_t j = 0; j < i; ++j)
            CHECK((mesh.vertices[i] - mesh.vertices[j]).norm() == doctest::Approx(0.7).epsilon(1e-14));
    }
    CHECK(sum.norm() < 1e-15);
}

TEST_CASE("shapes: a sphere's vertices lie on it, and its volume converges at second order")
{
    const auto missing = [](int subdivisions) {
        const SurfaceMesh mesh = sphere(0.5, subdivisions);
        for (const Vec3& x : mesh.vertices)
            CHECK(x.norm() == doctest::Approx(0.5).epsilon(1e-15));
        CHECK(mesh.faces.size() == 20u << (2 * subdivisions));
        return 1 - enclosed_volume(mesh) / (4.0 / 3 * pi * 0.125);
    };
    CHECK(missing(3) / missing(4) == doctest::Approx(4).epsilon(0.02));
    CHECK(missing(4) < 0.01);
}

TEST_CASE(
    "shapes: a torus of flat facets holds the area of its section times what the section's centre sweeps")
{
    for (const int around : {3, 16, 41})
        for (const int across : {3, 8}) {
            const double section = across * 0.09 / 2 * std::sin(2 * pi / across);
            CAPTURE(around);
            CAPTURE(across);
            CHECK(enclosed_volume(torus(0.7, 0.3, around, across)) ==
                  doctest::Approx(around * std::sin(2 * pi / around) * 0.7 * section).epsilon(1e-13));
        }
}

TEST_CASE("shapes: the wall of a bowl holds the volume between two faceted spheres and half a faceted torus")
{
    for (double foot : {0.0, 0.25}) {
        const BowlShape shape{.inner_radius = 1,
                              .thickness = 0.2,
                              .rim_angle = pi / 2,
                              .foot_radius = foot,
                              .segments_around = 24,
                              .segments_along = 9,
                              .segments_rim = 6};
        const double foot_angle = std::asin(foot / 1.2);
        const double outer = faceted_sphere_part(1.2, foot_angle, pi / 2, 9, 24);
        const double inner = faceted_sphere_part(1.0, 0, pi / 2, 9, 24);
        double rim = 0;  // with the rim at a right angle its half circle stands on the plane y = 0
        for (int i = 0; i < 3; ++i) {
            const double a = pi * i / 6, b = pi * (i + 1) / 6, rise = 0.1 * (std::sin(b) - std::sin(a));
            rim += frustum(1.1 + 0.1 * std::cos(a), 1.1 + 0.1 * std::cos(b), rise, 24);
            rim -= frustum(1.1 - 0.1 * std::cos(a), 1.1 - 0.1 * std::cos(b), rise, 24);
        }
        CAPTURE(foot);
        CHECK(enclosed_volume(bowl(shape)) == doctest::Approx(outer - inner + rim).epsilon(1e-13));
    }
}

TEST_CASE("shapes: a fine bowl holds the volume of the smooth one")
{
    const double r = 0.8, t = 0.1, R = r + t, angle = 1.1;
    const SurfaceMesh mesh = bowl({.inner_radius = r,
                                   .thickness = t,
                                   .rim_angle = angle,
                                   .segments_around = 200,
                                   .segments_along = 100,
                                   .segments_rim = 40});
    const double shell = 2 * pi / 3 * (R * R * R - r * r * r) * (1 - std::cos(angle));
    // Pappus: half a disc of radius t/2; its centroid lies 4 (t/2) / (3 pi)
    // beyond the middle of the rim, along the wall.
    const double centroid = (r + R) / 2 * std::sin(angle) + 4 * (t / 2) / (3 * pi) * std::cos(angle);
    const double rim = 2 * pi * centroid * pi * (t / 2) * (t / 2) / 2;
    CHECK(enclosed_volume(mesh) == doctest::Approx(shell + rim).epsilon(1e-3));
}

TEST_CASE("shapes: the three plane grids cover the same area, face up, and differ in their triangles")
{
    const std::array kinds{GridDiagonals::same, GridDiagonals::alternating, GridDiagonals::crossed};
    const std::array<std::size_t, 3> faces_per_cell{2, 2, 4};
    for (std::size_t kind = 0; kind < 3; ++kind) {
        const SurfaceMesh mesh = plane_grid(3, 2, {6, 4}, kinds[kind]);
        CAPTURE(kind);
        CHECK_NOTHROW(check_surface(mesh, "grid", Border::allowed));
        CHECK(mesh.faces.size() == 24 * faces_per_cell[kind]);
        Vec3 area = Vec3::Zero();
        for (const auto& [a, b, c] : mesh.faces) {
            const Vec3 origin = mesh.vertices[a];
            const Vec3 normal = (mesh.vertices[b] - origin).cross(mesh.vertices[c] - origin) / 2;
            CHECK(normal.y() > 0);
            area += normal;
        }
        CHECK((area - Vec3(0, 6, 0)).norm() < 1e-13);
    }
    CHECK(plane_grid(3, 2, {6, 4}).faces != plane_grid(3, 2, {6, 4}, GridDiagonals::alternating).faces);
}

TEST_CASE("shapes: impossible arguments are refused by name")
{
    const auto message = [](auto make) -> std::string {
        try {
            make();
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    CHECK(message([] { box({1, -1, 1}); }).find("size of a box is -1") == 0);
    CHECK(message([] { box({1, std::nan(""), 1}); }).find("size of a box is nan") == 0);
    CHECK(message([] { box({1, 1, 1}, {1, 0, 1}); }).find("cells is 0") == 0);
    CHECK(message([] { bar({1, 1, 1}, {1000, 1000, 1000}); }).find("cells") == 0);
    CHECK(message([] { sphere(1, 20); }).find("subdivisions of a sphere is 20") == 0);
    CHECK(message([] { torus(1, 1); }).find("tube_radius of a torus") == 0);
    CHECK(message([] { torus(1, 0.5, 2); }).find("around of a torus is 2") == 0);
    CHECK(message([] { slope({1, 1, 1}, 2); }).find("angle of a slope") == 0);
    CHECK(message([] { bowl({.rim_angle = 3.1}); }).find("rim_angle of a bowl") == 0);
    CHECK(message([] { bowl({.foot_radius = 0.5}); }).find("foot_radius of a bowl") == 0);
    CHECK(message([] { tetrahedron(0); }).find("edge_length of a tetrahedron") == 0);
}
