#include "chapters/06_redefinition/experiments/rolling.hpp"
#include "chapters/06_redefinition/experiments/levers.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace enduring;
using namespace enduring::chapter06;

TEST_CASE(
    "rolling: a ball that turns on its spot without friction loses what the lever of the step's start takes, to 7 percent")
{
    for (const PenaltyMethod method : {PenaltyMethod::discrete, PenaltyMethod::continuous})
        for (const double dt : {0.005, 0.0025}) {
            CAPTURE(dt);
            const RollOutcome outcome =
                roll({.method = method, .dt = dt, .slope_deg = 0, .mu_s = 0, .spin = 1, .duration = 0.4});
            CHECK(-outcome.spin_change == doctest::Approx(outcome.brake).epsilon(0.07));
        }
}

TEST_CASE(
    "rolling: down a slope a ball accelerates as the formula of the lever says, on a plane to 1 percent and on triangles to 3")
{
    for (const bool on_triangles : {false, true}) {
        const RollOutcome outcome = roll({.dt = 0.005, .on_triangles = on_triangles, .duration = 0.6});
        CHECK(std::abs(outcome.acceleration - outcome.exact + outcome.brake) <
              (on_triangles ? 0.03 : 0.01) * outcome.exact);
        CHECK(outcome.acceleration < 0.98 * outcome.exact);
    }
}

TEST_CASE(
    "levers: two free blocks gain the angular momentum of the levers at the step's start, a thousandth of what the end's would give")
{
    for (const double dt : {0.002, 0.001}) {
        const LeverCost cost = cost_of_levers({dt, 1});
        CHECK((cost.measured - cost.at_start).norm() < 1e-12);
        CHECK(cost.measured.norm() < 0.002 * cost.at_end.norm());
    }
}

TEST_CASE(
    "levers: at the step's end or middle they would cost as much as the blocks slide in a step or half of one, so half with half the step")
{
    const double speed = 1;
    const LeverCost whole = cost_of_levers({0.002, speed}), half = cost_of_levers({0.001, speed});
    CHECK(whole.at_end.norm() == doctest::Approx(whole.pushed * speed * 0.002).epsilon(0.05));
    CHECK(whole.in_middle.norm() == doctest::Approx(whole.at_end.norm() / 2).epsilon(0.01));
    CHECK(half.at_end.norm() == doctest::Approx(whole.at_end.norm() / 2).epsilon(0.06));
}
