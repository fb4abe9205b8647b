#include "chapters/09_deep_contacts/experiments/other_methods.hpp"
#include "chapters/09_deep_contacts/experiments/random_overlaps.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/moved_mesh.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace enduring;
using namespace enduring::chapter09;

namespace {

/// Ways of the inner one's vertices that are more than 45 degrees off.
long count_wrong(const std::vector<Vec3>& ways, const Vec3& right)
{
    return std::count_if(ways.begin(), ways.end(),
                         [&](const Vec3& way) { return way.dot(right) < std::sqrt(0.5); });
}

}  // namespace

TEST_CASE(
    "other methods: over a ledge's corner the nearest boundary sends vertices sideways, the vector area none")
{
    const OverlapShape ledge(moved(box({1, 1, 1}, {9, 9, 9}), {0.45, -0.5, 0.43})),
        cube(moved(box({0.4, 0.4, 0.4}, {5, 5, 5}), {0.013, 0.1, 0.021}));
    const auto overlaps = find_overlaps(cube.still(), ledge.still());
    REQUIRE(overlaps.size() == 1);
    const auto& [of_cube, of_ledge, separation_direction, curves] = overlaps[0];
    CHECK(count_wrong(overlap_direction(cube.still(), of_cube, ledge.still(), separation_direction),
                      Vec3::UnitY()) == 0);
    CHECK(count_wrong(overlap_direction(ledge.still(), of_ledge, cube.still(), -separation_direction),
                      -Vec3::UnitY()) == 0);
    const auto nearest = directions_to_the_boundary(cube.still(), of_cube, ledge.still(),
                                                    separation_direction);
    CHECK(count_wrong(nearest, Vec3::UnitY()) > 0);
    for (std::size_t i = 0; i < nearest.size(); ++i) {  // along it, out after the least depth of the box
        const Vec3 x = cube.positions()[of_cube[i]];
        const double least = std::min({-x.y(), x.x() - (-0.05), x.z() - (-0.07)});
        CHECK(find_exit(ledge.still(), x, nearest[i]).distance == doctest::Approx(least));
    }
}

TEST_CASE("other methods: the border hands the floor's normal on inwards, and without a border there is none")
{
    const OverlapShape floor(moved(box({2, 1, 2}, {19, 9, 19}), {0, -0.5, 0})),
        cube(moved(box({0.4, 0.4, 0.4}, {5, 5, 5}), {0.013, 0.1, 0.021})),
        sunk(moved(box({0.4, 0.4, 0.4}, {5, 5, 5}), {0.013, -0.25, 0.021}));
    const auto overlaps = find_overlaps(cube.still(), floor.still());
    REQUIRE(overlaps.size() == 1);
    const auto ways = directions_from_the_border(cube.still(), overlaps[0].vertices_of_a, floor.still(), {});
    CHECK(ways.size() > 30);
    for (const Vec3& way : ways)
        CHECK((way - Vec3::UnitY()).norm() < 1e-12);
    // The floor's vertices see the cube's sides at their border: sideways.
    const auto of_floor = directions_from_the_border(floor.still(), overlaps[0].vertices_of_b, cube.still(),
                                                     {});
    CHECK(count_wrong(of_floor, -Vec3::UnitY()) == static_cast<long>(of_floor.size()));
    const auto none = find_overlaps(sunk.still(), floor.still());
    REQUIRE(none.size() == 1);
    for (const Vec3& way : directions_from_the_border(sunk.still(), none[0].vertices_of_a, floor.still(), {}))
        CHECK(way.isZero(0));
}
