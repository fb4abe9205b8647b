#include "chapters/08_contact_by_distance/experiments/tops.hpp"
#include "common/input/input_error.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace enduring;
using namespace enduring::chapter08;

TEST_CASE("tops: the axis goes round as fast as the formula of steady precession says, and loses energy only")
{
    for (const auto& [spin, lean] : {std::pair(200.0, 30.0), std::pair(100.0, 10.0)}) {
        CAPTURE(spin);
        const Precession found = spin_top({.spin = spin, .lean_deg = lean, .dt = 0.001}, 1);
        CHECK(found.rate == doctest::Approx(found.by_formula).epsilon(3e-3));
        CHECK(std::abs(found.lean_change_deg) < 0.3);
        CHECK(found.energy_change < 1e-9);
        CHECK(found.energy_change > -5e-3);
        CHECK(found.tip_moved_mm < 1e-3);
        CHECK(found.solves.unconverged == 0);
    }
}

TEST_CASE("tops: what the axis leans more with long steps is in proportion to the step")
{
    const Precession coarse = spin_top({.spin = 100, .lean_deg = 30, .dt = 0.002}, 1),
                     fine = spin_top({.spin = 100, .lean_deg = 30, .dt = 0.0005}, 1);
    const double ratio = coarse.lean_change_deg / fine.lean_change_deg;
    CHECK(ratio > 3);
    CHECK(ratio < 5);
}

TEST_CASE("tops: steady precession solves its quadratic equation, and a slow top has none")
{
    const double across = 3e-3, along = 1.2e-3, moment = 0.25, lean = 0.4;
    const double rate = steady_precession(across, along, moment, 150, lean);
    CHECK(across * std::cos(lean) * rate * rate - along * 150 * rate + moment ==
          doctest::Approx(0).epsilon(1e-12));
    CHECK(rate < along * 150 / (2 * across * std::cos(lean)));  // the slow one of the two
    CHECK_THROWS_AS(steady_precession(across, along, moment, 30, lean), InputError);
}
