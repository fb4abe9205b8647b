#include "chapters/06_redefinition/experiments/buried_vertex.hpp"
#include "chapters/06_redefinition/experiments/ledger.hpp"
#include "common/experiments/render/reference.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/input/input_error.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace enduring;
using namespace enduring::chapter06;

namespace {

/// The number of a scene under a chapter's solver; fails where there is none.
double measured(const std::string& scene, int chapter)
{
    CAPTURE(scene);
    CAPTURE(chapter);
    const Outcome outcome = try_scene(motivating_scene(scene), chapter);
    REQUIRE_MESSAGE(outcome.value.has_value(), outcome.broken);
    return *outcome.value;
}

}  // namespace

TEST_CASE("through the side: chapter 5 throws a wedge up that should fall beside the table, chapter 6 lets it fall")
{
    CHECK(measured("through_the_side", 5) > 0);  // [m]: above the table it has left
    // It has left the edge by 0.2 s. Falling freely from there on, and from the very start on, are bounds of the height.
    const double height = measured("through_the_side", 6);
    CHECK(height < 0.042 - 0.5 * 9.81 * 0.4 * 0.4);
    CHECK(height > 0.042 - 0.5 * 9.81 * 0.6 * 0.6);
}

TEST_CASE("hooked: under chapter 6 the cube that stopped on triangles keeps its speed to a thousandth")
{
    CHECK(measured("hooked", 5) < 0.75);
    CHECK(measured("hooked", 6) == doctest::Approx(1.5).epsilon(0.001));
}

TEST_CASE("shifted: chapter 5 pushes where the tip came in, chapter 6 where it is, but for the way of one step")
{
    const double tip_speed = 1.2, dt = 0.005, way = 0.5 * tip_speed;
    CHECK(measured("shifted", 5) > 1000 * 0.8 * way);
    CHECK(measured("shifted", 6) < 1000 * 1.1 * tip_speed * dt);
}

TEST_CASE("shifted: the spike and the face that pushes its tip are as in their reference picture")
{
    const Outcome outcome = try_scene(motivating_scene("shifted"), 6, true);
    REQUIRE(outcome.picture.has_value());
    const ReferenceCheck check = check_reference_picture(*outcome.picture, "06_redefinition/shifted.png");
    CHECK_MESSAGE(check.passed, check.message);
}

TEST_CASE("false resolution: chapter 5 loses the tip when a triangle far away turns, chapter 6 does not")
{
    CHECK(measured("false_resolution", 5) > 5);  // [mm]
    CHECK(measured("false_resolution", 6) <= 0.04 * 0.005 * 1000);  // what it comes in by in one step, before its first push
}

TEST_CASE("deep: the one scene that redefinition makes worse")
{
    CHECK(measured("deep", 5) < 1.1);
    CHECK(measured("deep", 6) > 1.5);
}

TEST_CASE("failure ledger: the last solver that fails and the first that passes are where they are expected")
{
    for (const std::string& line : surprises(fill_ledger(motivating_scenes(), true, false)))
        FAIL_CHECK(line);
}

TEST_CASE("failure ledger: a cell that passes against expectation is told, and one that fails")
{
    MotivatingScene scene = motivating_scene("fast_plate");  // chapter 1 sees nothing, chapter 2 does
    scene.expected = "pfpppp";
    const std::vector<LedgerCell> cells{{&scene, 1, try_scene(scene, 1)}, {&scene, 2, try_scene(scene, 2)}};
    const std::vector<std::string> lines = surprises(cells);
    REQUIRE(lines.size() == 2);
    CHECK(lines[0].find("fast_plate under chapter 1 fails") == 0);
    CHECK(lines[0].find("expected to pass") != std::string::npos);
    CHECK(lines[1].find("fast_plate under chapter 2 passes") == 0);
    CHECK(lines[1].find("expected to fail") != std::string::npos);
}

TEST_CASE("failure ledger: nothing to measure is a failure, whichever side the bound is on")
{
    MotivatingScene scene = motivating_scene("shifted");
    for (const Bound bound : {Bound::at_least, Bound::at_most}) {
        scene.bound = bound;
        CHECK(!passes(scene, std::nullopt));
        CHECK(passes(scene, scene.limit));
    }
    CHECK_THROWS_AS(motivating_scene("shiftd"), InputError);
}

TEST_CASE("depth inside: that of a point in a box is the distance to the nearest side, outside it is 0")
{
    const SurfaceMesh mesh = box({1, 2, 3}, {2, 1, 3});
    const StaticBody body("box", SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces), mesh.vertices);
    for (const Vec3& x : {Vec3(0.1, 0.2, 0.3), Vec3(-0.4, 0.95, 1.2), Vec3(0.2, -0.3, -1.45)}) {
        CAPTURE(x.transpose());
        const double expected = std::min({0.5 - std::abs(x.x()), 1 - std::abs(x.y()), 1.5 - std::abs(x.z())});
        CHECK(depth_inside(body, x) == doctest::Approx(expected).epsilon(1e-12));
    }
    for (const Vec3& x : {Vec3(0.6, 0, 0), Vec3(0, 1.001, 0), Vec3(0.4, 0.9, -1.6)})
        CHECK(depth_inside(body, x) == 0);
}
