#include "chapters/05_categorisation/solver.hpp"
#include "chapters/06_redefinition/solver.hpp"
#include "chapters/motivating_scenes/motivating_scene.hpp"
#include "common/experiments/render/reference.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::motivating;

namespace {

/// The number of a scene under the solver of chapter 5 or 6; fails where there is none.
double measured(const std::string& scene, int chapter)
{
    CAPTURE(scene);
    CAPTURE(chapter);
    const Outcome outcome = try_scene(motivating_scene(scene),
                                      chapter == 5 ? chapter05_solver : chapter06_solver,
                                      limits_of(motivating_scene(scene), chapter));
    REQUIRE_MESSAGE(outcome.value.has_value(), outcome.broken);
    return *outcome.value;
}

}  // namespace

TEST_CASE(
    "through the side: chapter 5 throws a wedge up that should fall beside the table, chapter 6 lets it fall")
{
    CHECK(measured("through_the_side", 5) > 0);  // [m]: above the table it has left
    // It has left the edge by 0.2 s. Falling freely from there on, and from
    // the very start on, are bounds of the height.
    const double height = measured("through_the_side", 6);
    CHECK(height < 0.042 - 0.5 * 9.81 * 0.4 * 0.4);
    CHECK(height > 0.042 - 0.5 * 9.81 * 0.6 * 0.6);
}

TEST_CASE("hooked: under chapter 6 the cube that stopped on triangles keeps its speed to a thousandth")
{
    CHECK(measured("hooked", 5) < 0.75);
    CHECK(measured("hooked", 6) == doctest::Approx(1.5).epsilon(0.001));
}

TEST_CASE(
    "shifted: chapter 5 pushes where the tip came in, chapter 6 where it is, but for the way of one step")
{
    const double tip_speed = 1.2, dt = 0.005, way = 0.5 * tip_speed;
    CHECK(measured("shifted", 5) > 1000 * 0.8 * way);
    CHECK(measured("shifted", 6) < 1000 * 1.1 * tip_speed * dt);
}

TEST_CASE("shifted: the spike and the face that pushes its tip are as in their reference picture")
{
    const Outcome outcome = try_scene(motivating_scene("shifted"), chapter06_solver, {}, true);
    REQUIRE(outcome.picture.has_value());
    const ReferenceCheck check = check_reference_picture(*outcome.picture, "06_redefinition/shifted.png");
    CHECK_MESSAGE(check.passed, check.message);
}

TEST_CASE("false resolution: chapter 5 loses the tip when a triangle far away turns, chapter 6 does not")
{
    CHECK(measured("false_resolution", 5) > 5);  // [mm]
    // what it comes in by in one step, before its first push
    CHECK(measured("false_resolution", 6) <= 0.04 * 0.005 * 1000);
}

TEST_CASE("deep: the one scene that redefinition makes worse")
{
    CHECK(measured("deep", 5) < 1.1);
    CHECK(measured("deep", 6) > 1.5);
}
