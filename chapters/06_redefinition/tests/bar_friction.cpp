#include "chapters/06_redefinition/experiments/bar_friction.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::chapter06;

TEST_CASE("bar friction: a cube that friction has stopped on the soft bar stays within a micrometre" *
          doctest::test_suite("long simulation"))
{
    for (const FrictionCoefficients& mu : bar_coefficients) {
        CAPTURE(mu.mu_s);
        Scene scene = scene_of(mu);
        const RestOnBar rest = rest_on_bar(scene, 3000, 3500);
        CHECK(rest.way > 0.15);  // it has slid
        CHECK(rest.drift < 1e-6);
    }
}
