#include "chapters/09_deep_contacts/overlaps.hpp"
#include "chapters/09_deep_contacts/experiments/random_overlaps.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/moved_mesh.hpp"
#include "common/geometry/round_shapes.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace enduring;
using namespace enduring::chapter09;

namespace {

std::vector<Overlap> overlaps_of(const SurfaceMesh& a, const SurfaceMesh& b)
{
    const OverlapShape one(a), other(b);
    return find_overlaps(one.still(), other.still());
}

/// Sum of the vector areas of all curves.
Vec3 area_of(const SurfaceMesh& a, const SurfaceMesh& b)
{
    const OverlapShape one(a), other(b);
    const Intersection intersection = trace_intersection(one.still(), other.still());
    Vec3 area = Vec3::Zero();
    for (const IntersectionCurve& curve : intersection.curves)
        area += vector_area(intersection, curve, one.still(), other.still());
    return area;
}

}  // namespace

TEST_CASE(
    "separation direction: two boxes' vector area is how fast the volume that they share grows, wherever they stand")
{
    const Vec3 size_a(1, 0.8, 0.6), size_b(2, 2, 2);
    const SurfaceMesh a = box(size_a, {2, 2, 1}), b = box(size_b, {3, 1, 2});
    for (const Vec3& place :
         {Vec3(0.1, 1.2, 0.2), Vec3(1.3, 0.9, 0.1), Vec3(-1.2, 0.9, 1.1), Vec3(0.02, -1.3, 0.03)})
        for (const Vec3& origin : {Vec3(0, 0, 0), Vec3(10, -20, 7)}) {
            CAPTURE(place.transpose());
            // The volume is the product of three lengths, of each of which one end moves with A, or both, or
            // none.
            Vec3 length, growth;
            for (int i = 0; i < 3; ++i) {
                const double low_a = place[i] - size_a[i] / 2, high_a = place[i] + size_a[i] / 2;
                length[i] = std::min(high_a, size_b[i] / 2) - std::max(low_a, -size_b[i] / 2);
                growth[i] = (high_a < size_b[i] / 2) - (low_a > -size_b[i] / 2);
            }
            const Vec3 expected(growth[0] * length[1] * length[2], growth[1] * length[0] * length[2],
                                growth[2] * length[0] * length[1]);
            const SurfaceMesh one = moved(a, place + origin), other = moved(b, origin);
            CHECK((area_of(one, other) - expected).norm() < 1e-9);
            CHECK((area_of(other, one) + expected).norm() < 1e-9);
        }
}

TEST_CASE(
    "separation direction: a body that a plate passes right through shares one volume with it and has one way out")
{
    const SurfaceMesh plate = slope({2, 0.1, 2}, std::numbers::pi / 18, {2, 1, 8}), stone = tetrahedron(1);
    for (const bool plate_first : {true, false}) {
        const auto found = plate_first ? overlaps_of(plate, stone) : overlaps_of(stone, plate);
        REQUIRE(found.size() == 1);
        CHECK(found[0].curves.size() == 2);
        CHECK((plate_first ? found[0].vertices_of_a : found[0].vertices_of_b).size() == 4);
        // the stone is narrower above, so the volume shrinks as the stone goes down, across the plate
        const Vec3 up(-std::sin(std::numbers::pi / 18), std::cos(std::numbers::pi / 18), 0);
        CHECK((found[0].separation_direction - (plate_first ? up : -up)).norm() < 1e-9);
    }
    const auto pin = overlaps_of(moved(box({0.1, 1, 0.1}), {0.3, 0.05, 0.11}), box({2, 0.2, 2}));
    REQUIRE(pin.size() == 1);
    CHECK(pin[0].curves.size() == 2);
    CHECK(pin[0].vertices_of_a.empty());
    CHECK(pin[0].vertices_of_b.empty());
    CHECK(std::abs(pin[0].separation_direction.y()) == doctest::Approx(1));
}

TEST_CASE("separation direction: a ball leaves a floor upwards, and the floor leaves the ball downwards")
{
    const SurfaceMesh floor = moved(box({4, 1, 4}, {5, 1, 5}), {0, -0.5, 0});
    const SurfaceMesh ball = moved(sphere(0.4, 2), {0.03, 0.1, 0.05});
    const auto from_ball = overlaps_of(ball, floor), from_floor = overlaps_of(floor, ball);
    REQUIRE(from_ball.size() == 1);
    REQUIRE(from_floor.size() == 1);
    CHECK((from_ball[0].separation_direction - Vec3::UnitY()).norm() < 1e-9);
    CHECK((from_floor[0].separation_direction + Vec3::UnitY()).norm() < 1e-9);
    CHECK(from_ball[0].vertices_of_a == from_floor[0].vertices_of_b);
    for (const int vertex : from_ball[0].vertices_of_a)
        CHECK(ball.vertices[vertex].y() < 0);
}

TEST_CASE(
    "separation direction: what is wholly inside takes the shortest path, also where it begins at two sides")
{
    const SurfaceMesh room = box({4, 4, 4}, {3, 3, 3}), small = box({0.5, 0.5, 0.5});
    const auto right = overlaps_of(moved(small, {1.2, 0.3, -0.2}), room);
    REQUIRE(right.size() == 1);
    CHECK((right[0].separation_direction - Vec3::UnitX()).norm() < 1e-12);
    CHECK(right[0].vertices_of_a.size() == 8);
    CHECK(right[0].vertices_of_b.empty());
    // A rod from wall to wall: its ends are next to the walls, but it is out first by the floor.
    const auto rod = overlaps_of(moved(box({3.8, 0.2, 0.2}, {6, 1, 1}), {0.01, -1.2, 0}), room);
    REQUIRE(rod.size() == 1);
    CHECK((rod[0].separation_direction + Vec3::UnitY()).norm() < 1e-12);
}

TEST_CASE("separation direction: two feet of one body are two overlaps, each with its own direction")
{
    const SurfaceMesh wall = box({0.5, 3, 3}, {1, 2, 2});  // two walls, a rod that ends in both
    SurfaceMesh walls = moved(wall, {-1, 0, 0});
    const int count = static_cast<int>(walls.vertices.size());
    const SurfaceMesh right = moved(wall, {1, 0, 0});
    walls.vertices.insert(walls.vertices.end(), right.vertices.begin(), right.vertices.end());
    for (Face face : right.faces) {
        for (int& vertex : face)
            vertex += count;
        walls.faces.push_back(face);
    }
    const auto overlaps = overlaps_of(moved(box({1.7, 0.2, 0.2}), {0, 0.03, 0.07}), walls);
    REQUIRE(overlaps.size() == 2);
    CHECK((overlaps[0].separation_direction + overlaps[1].separation_direction).norm() < 1e-9);
    CHECK(std::abs(overlaps[0].separation_direction.x()) > 1 - 1e-9);
    CHECK(overlaps[0].vertices_of_a.size() == 4);
    CHECK(overlaps[1].vertices_of_a.size() == 4);
}

TEST_CASE(
    "separation direction: curves of one rod in two walls are not joined by the rod's ends, which are outside")
{
    const SurfaceMesh plate = box({0.1, 3, 3}, {1, 2, 2});
    SurfaceMesh plates = moved(plate, {-0.5, 0, 0});
    const int count = static_cast<int>(plates.vertices.size());
    const SurfaceMesh right = moved(plate, {0.5, 0, 0});
    plates.vertices.insert(plates.vertices.end(), right.vertices.begin(), right.vertices.end());
    for (Face face : right.faces) {
        for (int& vertex : face)
            vertex += count;
        plates.faces.push_back(face);
    }
    const auto overlaps = overlaps_of(moved(box({3, 0.2, 0.2}), {0, 0.23, 0.17}), plates);
    REQUIRE(overlaps.size() ==
            2);  // no vertex is inside: the rod's edges tell which two of the four curves bound one volume
    for (const Overlap& overlap : overlaps)
        CHECK(overlap.curves.size() == 2);
}

TEST_CASE("exit: the first face behind the point, where a straight way meets it")
{
    const OverlapShape room(box({2, 2, 2}, {3, 3, 3}));
    const Vec3 point(0.2, -0.3, 0.1), way = Vec3(0.1, 1, 0.2).normalized();
    const Exit exit = find_exit(room.still(), point, way);
    REQUIRE(exit.face >= 0);
    CHECK(exit.distance == doctest::Approx(1.3 / way.y()).epsilon(1e-12));
    Vec3 there = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i)
        there += exit.weights[i] * room.positions()[room.still().topology.faces()[exit.face][i]];
    CHECK((there - (point + exit.distance * way)).norm() < 1e-12);
    CHECK(find_exit(room.still(), Vec3(0, 5, 0), Vec3::UnitY()).face < 0);
}
