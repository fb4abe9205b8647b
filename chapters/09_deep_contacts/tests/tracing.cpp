#include "chapters/09_deep_contacts/experiments/random_overlaps.hpp"
#include "chapters/09_deep_contacts/overlaps.hpp"
#include "common/geometry/box_shapes.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::chapter09;

TEST_CASE("tracing: 200 random overlaps, half on a lattice, close all curves and flood what solid angles say")
{
    const auto meshes = overlap_meshes();
    std::mt19937_64 random(12);
    OverlapCheck all;
    for (std::size_t i = 0; i < 200; ++i) {
        const bool on_lattice = i % 2 == 1;
        const auto &a = meshes[i / 2 % meshes.size()], &b = meshes[i / 10 % meshes.size()];
        CAPTURE(i);
        CAPTURE(a.first);
        CAPTURE(b.first);
        const SurfaceMesh placed_a = place_at_random(a.second, random, on_lattice);
        const OverlapCheck check = check_overlap(placed_a, place_at_random(b.second, random, on_lattice),
                                                 on_lattice, 40);
        CHECK(check.open_curves == 0);
        CHECK(check.wrong == 0);
        all.curves += check.curves;
        all.inside += check.inside;
    }
    CHECK(all.curves > 200);
    CHECK(all.inside > 2000);
}

TEST_CASE("tracing: a cube that stands in a cube of its size crosses it in closed curves, whatever coincides")
{
    for (const Vec3& moved : {Vec3(0, 0, 0), Vec3(0.5, 0, 0), Vec3(0.5, 0.5, 0), Vec3(1, 0, 0), Vec3(1, 1, 0),
                              Vec3(1, 1, 1), Vec3(-1, 0, 0.5)}) {
        SurfaceMesh mesh = box({1, 1, 1}, {2, 2, 2});
        const OverlapShape still(mesh);
        for (Vec3& x : mesh.vertices)
            x += moved;
        const OverlapShape other(mesh);
        const Intersection intersection = trace_intersection(still.still(), other.still());
        CAPTURE(moved.transpose());
        for (const IntersectionCurve& curve : intersection.curves)
            CHECK(curve.closed);
    }
}

TEST_CASE("tracing: a corner in a floor has one curve of its three edges, and one region of one vertex")
{
    SurfaceMesh corner = box({1, 1, 1});
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Vec3(1, 1, 1), Vec3(0.1, -1, 0.05));
    for (Vec3& x : corner.vertices)
        x = turn * x + Vec3(0.013, 0.8, 0.021);
    const OverlapShape cube(corner), floor(box({4, 0.5, 4}));
    const Intersection intersection = trace_intersection(cube.still(), floor.still());
    REQUIRE(intersection.curves.size() == 1);
    CHECK(intersection.curves[0].closed);
    const SurfaceRegions of_cube = flood_regions(intersection.piercings, cube.still(), floor.still(), true);
    int inside = 0;
    for (int vertex = 0; vertex < 8; ++vertex)
        inside += of_cube.winding_of_vertex(vertex) == 1;
    CHECK(inside == 1);
    CHECK(of_cube.winding.size() == 2);
    const SurfaceRegions of_floor = flood_regions(intersection.piercings, cube.still(), floor.still(), false);
    CHECK(of_floor.winding == std::vector<int>{0});
}

TEST_CASE("tracing: a curve over the border of an open sheet ends there, twice")
{
    const OverlapShape sheet(plane_grid(2, 2, {3, 3}));
    SurfaceMesh moved = box({1, 1, 1});
    for (Vec3& x : moved.vertices)
        x += Vec3(1.013, 0.1, 0.017);
    const OverlapShape cube(moved);
    const Intersection intersection = trace_intersection(cube.still(), sheet.still());
    REQUIRE(intersection.curves.size() == 1);
    CHECK_FALSE(intersection.curves[0].closed);
    CHECK(intersection.curves[0].piercings.size() == intersection.piercings.size());
}

TEST_CASE("tracing: without a curve the ray tells what is wholly inside, also by whom it is held")
{
    const OverlapShape small(box({0.5, 0.5, 0.5})), large(box({1, 1, 1}));
    const Intersection none = trace_intersection(small.still(), large.still());
    CHECK(none.curves.empty());
    CHECK(flood_regions(none.piercings, small.still(), large.still(), true).winding == std::vector<int>{1});
    CHECK(flood_regions(none.piercings, small.still(), large.still(), false).winding == std::vector<int>{0});
}
