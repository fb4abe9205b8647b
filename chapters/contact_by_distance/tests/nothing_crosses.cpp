#include "chapters/contact_by_distance/tests/random_scenes.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::distance_tests;

TEST_CASE(
    "contact by distance: nothing crosses in random scenes, by winding numbers and by edges through faces")
{
    for (unsigned seed = 0; seed < 40; ++seed) {
        RandomScene scene = random_scene(seed);
        CAPTURE(seed);
        CHECK(crossed_steps(scene, distance_solver({})) == 0);
    }
}
