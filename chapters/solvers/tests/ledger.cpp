#include "chapters/solvers/ledger.hpp"
#include "chapters/motivating_scenes/buried_vertex.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/input/input_error.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace enduring;
using namespace enduring::solvers;

TEST_CASE("failure ledger: the last solver that fails and the first that passes are where they are expected")
{
    for (const std::string& line : surprises(fill_ledger(motivating_scenes(), true, false)))
        FAIL_CHECK(line);
}

TEST_CASE("failure ledger: a cell that passes against expectation is told, and one that fails")
{
    MotivatingScene scene = motivating_scene("fast_plate");  // chapter 1 sees nothing, chapter 2 does
    scene.expected = "pfppppppp";
    const std::vector<LedgerCell> cells{{&scene, 1, try_chapter(scene, 1)},
                                        {&scene, 2, try_chapter(scene, 2)}};
    const std::vector<std::string> lines = surprises(cells);
    REQUIRE(lines.size() == 2);
    CHECK(lines[0].find("fast_plate under chapter 1 fails") == 0);
    CHECK(lines[0].find("expected to pass") != std::string::npos);
    CHECK(lines[1].find("fast_plate under chapter 2 passes") == 0);
    CHECK(lines[1].find("expected to fail") != std::string::npos);
}

TEST_CASE(
    "failure ledger: Bullet has a cell in every row that it answers, and its surprises are told by name")
{
    for (const MotivatingScene& scene : motivating_scenes()) {
        CAPTURE(scene.name);
        CHECK(std::string("pf-").find(expectation(scene, bullet_column)) != std::string::npos);
    }
    std::vector<MotivatingScene> scenes{motivating_scene("fast_plate"), motivating_scene("labels")};
    scenes[0].with_bullet = 'f';
    scenes[0].expected = scenes[1].expected = std::string(last_chapter, 'f');
    const std::vector<LedgerCell> cells = fill_ledger(scenes, true, false);
    REQUIRE(cells.size() == 5);  // the first and the last chapter of both, and Bullet in the first
    CHECK(cells[2].column == bullet_column);
    const std::vector<std::string> lines = surprises(cells);
    CHECK(std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
        return line.find("fast_plate under Bullet passes") == 0;
    }));
}

TEST_CASE("failure ledger: the chapter with joints holds both bars, and without joints the lower one falls")
{
    const MotivatingScene& scene = motivating_scene("double_pendulum");
    const Outcome held = try_chapter(scene, last_chapter), falls = try_chapter(scene, last_chapter - 1);
    REQUIRE(held.broken.empty());
    CHECK(held.value.value() < 1e-9);
    // the upper bar swings below its nail, or nothing would be left to hang on
    REQUIRE(falls.broken.empty());
    CHECK(falls.value.value() > 200);
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
    const StaticBody body("box", SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces),
                          mesh.vertices);
    for (const Vec3& x : {Vec3(0.1, 0.2, 0.3), Vec3(-0.4, 0.95, 1.2), Vec3(0.2, -0.3, -1.45)}) {
        CAPTURE(x.transpose());
        const double expected = std::min({0.5 - std::abs(x.x()), 1 - std::abs(x.y()), 1.5 - std::abs(x.z())});
        CHECK(depth_inside(body, x) == doctest::Approx(expected).epsilon(1e-12));
    }
    for (const Vec3& x : {Vec3(0.6, 0, 0), Vec3(0, 1.001, 0), Vec3(0.4, 0.9, -1.6)})
        CHECK(depth_inside(body, x) == 0);
}
