#include "chapters/07_implicit_contact/experiments/true_depth.hpp"
#include "chapters/08_contact_by_distance/experiments/jam_scenes.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::chapter08;

TEST_CASE("jams: no body begins inside another one or a plane, and another seed gives another scene")
{
    for (const Jam jam : all_jams)
        for (unsigned seed = 1; seed <= 20; ++seed) {
            CAPTURE(name_of(jam));
            CAPTURE(seed);
            const Scene scene = random_jam(jam, seed);
            CHECK(chapter07::true_depth(scene.world) <= 1e-12);
            CHECK(scene.dt != random_jam(jam, seed + 1).dt);
        }
}
