#include "chapters/08_contact_by_distance/experiments/gaps.hpp"
#include "chapters/08_contact_by_distance/experiments/random_scenes.hpp"
#include "chapters/08_contact_by_distance/experiments/shapes.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace enduring;
using namespace enduring::chapter08;

namespace {

/// Steps of a random scene after which surfaces cross.
long crossing_steps_of(unsigned seed)
{
    Scene scene = random_scene(seed);
    return crossing_steps(scene, random_scene_steps);
}

}  // namespace

TEST_CASE(
    "contact by distance: nothing crosses in random scenes, by winding numbers and by edges through faces")
{
    for (unsigned seed = 0; seed < 40; ++seed) {
        CAPTURE(seed);
        CHECK(crossing_steps_of(seed) == 0);
    }
}

TEST_CASE("contact by distance: nothing crosses where the new pairs lie at the places of known ones")
{
    CHECK(crossing_steps_of(814) == 0);
}

TEST_CASE(
    "contact by distance: nothing crosses where a vertex slides from its face behind the next one of a flat side")
{
    constexpr int lumps = 6;
    Scene scene = random_heap({lumps, 8, 0.02, 0.2, 49});
    CHECK(family_name(lumps) == "lumps");
    CHECK(crossing_steps(scene, 40) == 0);
}

TEST_CASE("contact by distance: nothing crosses where edges slide past each other's ends")
{
    constexpr int u_shapes = 5;
    Scene scene = random_heap({u_shapes, 14, 0.04, 0.1, 10007});
    CHECK(family_name(u_shapes) == "U shapes");
    CHECK(crossing_steps(scene, 26) == 0);
}

TEST_CASE("contact by distance: where nothing touches nothing pushes, however thin the gap and long the step")
{
    for (const double gap : {2e-3, 4e-4, 1e-6})
        for (const double dt : {0.001, 0.01, 0.04}) {
            CAPTURE(gap);
            CAPTURE(dt);
            const GapRun combs = run_gap(scene_of(Combs{.play = gap, .dt = dt}), 10),
                         plates = run_gap(plates_apart(gap, dt), 10), cups = run_gap(cups_apart(gap, dt), 5),
                         links = run_gap(links_apart(gap, dt), 5), paper = run_gap(paper_apart(gap, dt), 5),
                         gears = run_gap(gears_apart(gap, dt), 5),
                         bolt = run_gap(bolt_apart(std::clamp(gap, least_bolt_play, most_bolt_play), dt), 5);
            for (const GapRun& run : {combs, plates, cups, links, paper, gears, bolt}) {
                CHECK(run.pushed == 0);
                CHECK(run.off_fall < 1e-11);
            }
        }
}
