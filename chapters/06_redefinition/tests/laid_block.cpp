#include "chapters/06_redefinition/experiments/laid_block.hpp"

#include <doctest/doctest.h>

#include <initializer_list>

using namespace enduring::chapter06;

TEST_CASE(
    "laid block: a gap of a billionth of a millimetre is enough for all corners to be found, and no energy to speak of is made")
{
    for (const double slope : {10.0, 15.0})
        for (const double turned : {0.0, 0.3}) {
            const LaidOutcome outcome = lay({1e-12, slope, turned});
            CHECK(outcome.corners_missed == 0);
            CHECK(outcome.energy_gained < 10);
        }
}

TEST_CASE(
    "laid block: laid exactly, a corner that rounding puts inside is not found, and the block is thrown off")
{
    const LaidOutcome outcome = lay({0, 10, 0.3});
    CHECK(outcome.corners_missed > 0);
    CHECK(outcome.energy_gained > 1000);
}
