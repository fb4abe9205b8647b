#include "chapters/08_speculative_contacts/vertex_walls.hpp"
#include "chapters/08_speculative_contacts/tests/moving_surface.hpp"
#include "common/geometry/box_shapes.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace enduring;
using namespace enduring::chapter08;

namespace {

/// @param tau  0: near at the start; else of the crossing
FaceMeeting meets(int face, double cost, double tau = 0)
{
    Meeting meeting;
    meeting.tau = tau;
    meeting.cost = cost;
    meeting.passes = tau > 0;
    return {face, meeting};
}

/// Near at the start, and passes.
FaceMeeting passes(int face, double cost)
{
    FaceMeeting one = meets(face, cost);
    one.meeting.passes = true;
    return one;
}

std::vector<int> chosen(const MovingSurface& surface, std::vector<FaceMeeting> meetings)
{
    std::vector<int> faces;
    for (const FaceMeeting& one : choose_walls(surface.step(), std::move(meetings)))
        faces.push_back(one.face);
    return faces;
}

/// A face of a surface whose normal has this direction, the first of them.
int facing(const MovingSurface& surface, const Vec3& direction, int skip = 0)
{
    for (int face = 0; face < static_cast<int>(surface.topology.faces().size()); ++face)
        if (surface.start().face_normal(face).normalized().dot(direction) > 0.999 && skip-- == 0)
            return face;
    return -1;
}

using Faces = std::vector<int>;

}  // namespace

TEST_CASE("vertex walls: of coplanar triangles only the nearest counts, and of equal ones the first")
{
    for (const double scale : {1e-3, 1.0, 100.0}) {
        const MovingSurface flat(placed(plane_grid(2, 2, {2, 2}), scale));
        CAPTURE(scale);
        CHECK(chosen(flat, {meets(3, 0.2), meets(1, 0.3), meets(6, 0.1)}) == Faces{6});
        CHECK(chosen(flat, {meets(3, 0.2), meets(1, 0.2), meets(6, 0.2)}) == Faces{1});
    }
    CHECK(chosen(MovingSurface(plane_grid(2, 2, {2, 2})), {}).empty());
}

TEST_CASE("vertex walls: both walls of a valley count, the nearer one first")
{
    Draw draw(1);
    for (const double scale : {1e-3, 1.0, 100.0}) {
        const Quaternion turn = draw.turn();
        const MovingSurface valley(placed(prism_over_l(), scale, turn, scale * draw.direction()));
        const int floor = facing(valley, turn * Vec3::UnitY()),
                  wall = facing(valley, turn * Vec3::UnitX(), 2);
        REQUIRE(floor >= 0);
        REQUIRE(wall >= 0);
        const auto stands_at_the_hollow = [&](int face) {
            const Face& corners = valley.topology.faces()[static_cast<std::size_t>(face)];
            return std::count(corners.begin(), corners.end(), 3) +
                   std::count(corners.begin(), corners.end(), 9);
        };
        REQUIRE(stands_at_the_hollow(floor) > 0);
        REQUIRE(stands_at_the_hollow(wall) > 0);
        CAPTURE(scale);
        CHECK(chosen(valley, {meets(floor, 0.1), meets(wall, 0.2)}) == Faces{floor, wall});
        CHECK(chosen(valley, {meets(floor, 0.2), meets(wall, 0.1)}) == Faces{wall, floor});
    }
}

TEST_CASE("vertex walls: of a ridge only one side counts, and never the far side of a plate")
{
    const MovingSurface plate(box({1, 0.01, 1}));
    const int top = facing(plate, Vec3::UnitY()), side = facing(plate, Vec3::UnitX()),
              bottom = facing(plate, -Vec3::UnitY());
    CHECK(chosen(plate, {meets(top, 0.1), meets(side, 0.2)}) == Faces{top});
    CHECK(chosen(plate, {meets(top, 0.2), meets(side, 0.1)}) == Faces{side});
    CHECK(chosen(plate, {meets(top, 0.001), meets(bottom, 0.009)}) == Faces{top});
    CHECK(chosen(plate, {meets(top, 0.001), meets(bottom, 0.009), meets(side, 0.02)}) == Faces{top});
}

TEST_CASE(
    "vertex walls: a wall of the start comes before one that is crossed later, and the earlier crossing first")
{
    const MovingSurface flat(plane_grid(2, 2, {2, 2}));
    CHECK(chosen(flat, {meets(3, 0.9), meets(5, 0.5, 0.5)}) == Faces{3});
    CHECK(chosen(flat, {meets(1, 0.6, 0.6), meets(5, 0.5, 0.5)}) == Faces{5});
}

TEST_CASE("vertex walls: what a vertex passes in the step counts, whichever face is nearer at its start")
{
    const MovingSurface plate(box({1, 0.01, 1}));
    const int top = facing(plate, Vec3::UnitY()), side = facing(plate, Vec3::UnitX());
    CHECK(chosen(plate, {meets(top, 0.1), meets(side, 0.5, 0.5)}) == Faces{top, side});
    CHECK(chosen(plate, {meets(top, 0.1), passes(side, 0.2)}) == Faces{top, side});
}

TEST_CASE("vertex walls: where a surface bends in the step, its walls are those of the moment that tells")
{
    MovingSurface bending(hinge(-0.5));  // a ridge that becomes a valley
    bending.t1 = hinge(0.5).vertices;
    CHECK(chosen(bending, {meets(0, 0.1), meets(1, 0.2)}) == Faces{0});
    CHECK(chosen(bending, {meets(0, 1, 1), meets(1, 1, 1)}) == Faces{0, 1});
}

TEST_CASE("vertex walls: of a blunt ridge only one side counts, and of a blunt valley both, at any size")
{
    for (const double scale : {1e-6, 1e-3, 1.0, 100.0})
        for (const double angle : {0.02, 2 * search_parts.least_fold}) {
            const MovingSurface ridge(placed(hinge(-angle), scale)), valley(placed(hinge(angle), scale));
            CAPTURE(scale);
            CAPTURE(angle);
            CHECK(chosen(ridge, {meets(0, 0.1), meets(1, 0.2)}) == Faces{0});
            CHECK(chosen(valley, {meets(0, 0.1), meets(1, 0.2)}) == Faces{0, 1});
        }
}

TEST_CASE("vertex walls: sides that fold by less than what counts as an edge are one wall")
{
    const MovingSurface flat(hinge(0.5 * search_parts.least_fold));
    CHECK(chosen(flat, {meets(0, 0.1), meets(1, 0.2)}) == Faces{0});
}
