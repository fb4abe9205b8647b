#include "chapters/08_contact_by_distance/experiments/fast_shots.hpp"

#include <doctest/doctest.h>

using namespace enduring::chapter08;

TEST_CASE("fast: what flies ten metres in a step does not come through a plate of two millimetres")
{
    for (const FastVolley::Shape shape : {FastVolley::Shape::ball, FastVolley::Shape::box})
        for (const double dt : {0.01, 0.002})
            for (const unsigned seed : {1U, 3U, 9U}) {
                CAPTURE(static_cast<int>(shape));
                CAPTURE(dt);
                CAPTURE(seed);
                const FastOutcome outcome = shoot({false, 1000, shape, FastVolley::Way::straight}, dt, seed);
                CHECK(outcome.through == 0);
                CHECK(outcome.max_energy < 1 + 1e-9);
            }
}
