#include "chapters/08_contact_by_distance/experiments/gaps.hpp"
#include "chapters/08_contact_by_distance/experiments/random_scenes.hpp"
#include "chapters/08_contact_by_distance/experiments/shapes.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::chapter08;

namespace {

/// Steps of a random scene after which surfaces cross.
int crossing_steps(unsigned seed)
{
    ImplicitSettings quiet;
    quiet.record = [](const SolveRecord&) {};
    Scene scene = random_scene(seed);
    const Solver solver = chapter08_solver(scene.contact, quiet);
    Contacts contacts;
    int crossing = 0;
    for (int step = 0; step < random_scene_steps; ++step) {
        advance(scene.world, contacts, solver, scene.dt);
        crossing += any_crossing(scene.world);
    }
    return crossing;
}

}  // namespace

TEST_CASE(
    "contact by distance: nothing crosses in random scenes, by winding numbers and by edges through faces")
{
    for (unsigned seed = 0; seed < 40; ++seed) {
        CAPTURE(seed);
        CHECK(crossing_steps(seed) == 0);
    }
}

TEST_CASE("contact by distance: nothing crosses where the new pairs lie at the places of known ones")
{
    CHECK(crossing_steps(814) == 0);
}

TEST_CASE(
    "contact by distance: nothing crosses where a vertex slides from its face behind the next one of a flat side")
{
    ImplicitSettings quiet;
    quiet.record = [](const SolveRecord&) {};
    constexpr int lumps = 6;
    Scene scene = random_heap({lumps, 8, 0.02, 0.2, 49});
    const Solver solver = chapter08_solver(scene.contact, quiet);
    Contacts contacts;
    int crossing = 0;
    for (int step = 0; step < 40; ++step) {
        advance(scene.world, contacts, solver, scene.dt);
        crossing += any_crossing(scene.world);
    }
    CHECK(family_name(lumps) == "lumps");
    CHECK(crossing == 0);
}

TEST_CASE("contact by distance: where nothing touches nothing pushes, however thin the gap and long the step")
{
    for (const double gap : {2e-3, 4e-4, 1e-6})
        for (const double dt : {0.001, 0.01, 0.04}) {
            CAPTURE(gap);
            CAPTURE(dt);
            const GapRun combs = run_gap(scene_of(Combs{.play = gap, .dt = dt}), 10),
                         plates = run_gap(plates_apart(gap, dt), 10);
            CHECK(combs.pushed == 0);
            CHECK(combs.off_fall < 1e-12);
            CHECK(plates.pushed == 0);
            CHECK(plates.off_fall < 1e-12);
        }
}
