#include "chapters/08_speculative_contacts/tests/moving_surface.hpp"
#include "chapters/08_speculative_contacts/vertex_walls.hpp"
#include "common/geometry/box_shapes.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::chapter08;

namespace {

using Faces = std::vector<int>;

/// Near at the start, at this cost.
FaceMeeting near(int face, double cost)
{
    Meeting meeting;
    meeting.cost = cost;
    return {face, meeting};
}

Faces chosen(const MovingSurface& surface, std::vector<FaceMeeting> meetings)
{
    Faces faces;
    for (const FaceMeeting& one : choose_walls(surface.step(), std::move(meetings)))
        faces.push_back(one.face);
    return faces;
}

/// A floor that faces up, and a wall that faces +x and stands in its middle: behind the wall the floor goes on.
MovingSurface wall_in_the_middle()
{
    return MovingSurface(
        {{{-1, 0, 1}, {1, 0, 1}, {0, 0, -1}, {0, 0, 0.5}, {0, 0, -0.5}, {0, 1, 0}}, {{0, 1, 2}, {3, 4, 5}}});
}

}  // namespace

TEST_CASE("vertex walls: each of two walls has to stand before the other one")
{
    const MovingSurface surface = wall_in_the_middle();
    REQUIRE(surface.start().face_normal(0).y() > 0);
    REQUIRE(surface.start().face_normal(1).x() > 0);
    CHECK(chosen(surface, {near(0, 0.1), near(1, 0.2)}) == Faces{0});
    CHECK(chosen(surface, {near(0, 0.2), near(1, 0.1)}) == Faces{1});
}

TEST_CASE("vertex walls: another side near which a vertex began, and which it does not pass, does not count")
{
    const MovingSurface plate(box({1, 0.01, 1}));
    const auto facing = [&](const Vec3& direction) {
        for (int face = 0; face < 12; ++face)
            if (plate.start().face_normal(face).normalized().dot(direction) > 0.999)
                return face;
        return -1;
    };
    const int top = facing(Vec3::UnitY()), side = facing(Vec3::UnitX());
    CHECK(chosen(plate, {near(top, 0.1), near(side, 0.2)}) == Faces{top});
}

TEST_CASE("vertex walls: a third wall has to agree with the first one, too")
{
    const MovingSurface l(prism_over_l());
    Faces floors, walls;
    for (int face = 0; face < static_cast<int>(l.topology.faces().size()); ++face) {
        const Face& corners = l.topology.faces()[static_cast<std::size_t>(face)];
        const Vec3 normal = l.start().face_normal(face).normalized();
        const bool at_the_hollow =
            std::count(corners.begin(), corners.end(), 3) + std::count(corners.begin(), corners.end(), 9) > 0;
        if (at_the_hollow && normal.y() > 0.999)
            floors.push_back(face);
        if (at_the_hollow && normal.x() > 0.999)
            walls.push_back(face);
    }
    REQUIRE(floors.size() == 2);
    REQUIRE(walls.size() == 2);
    CHECK(chosen(l, {near(floors[0], 0.1), near(walls[0], 0.2), near(floors[1], 0.3)}) ==
          Faces{floors[0], walls[0]});
}

TEST_CASE("vertex walls: the walls of a shallow valley are two")
{
    for (const double angle : {0.01, 0.1})
        CHECK(chosen(MovingSurface(hinge(angle)), {near(0, 0.1), near(1, 0.2)}) == Faces{0, 1});
}
