#include "chapters/08_contact_by_distance/experiments/gaps.hpp"
#include "chapters/08_contact_by_distance/experiments/random_scenes.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::chapter08;

TEST_CASE(
    "contact by distance: nothing crosses in random scenes, by winding numbers and by edges through faces")
{
    ImplicitSettings quiet;
    quiet.record = [](const SolveRecord&) {};
    for (unsigned seed = 0; seed < 40; ++seed) {
        Scene scene = random_scene(seed);
        const Solver solver = chapter08_solver(scene.contact, quiet);
        Contacts contacts;
        CAPTURE(seed);
        for (int step = 0; step < random_scene_steps; ++step) {
            advance(scene.world, contacts, solver, scene.dt);
            CAPTURE(step);
            CHECK_FALSE(any_crossing(scene.world));
        }
    }
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
