#include "exercises/01_particle_plane/4_what_a_bounce_costs.hpp"
#include "exercises/checking.hpp"

#include <cmath>
#include <numbers>

namespace enduring {
namespace {

ParticleProblem bounce(double dt, PenaltyMethod method = PenaltyMethod::continuous)
{
    ParticleProblem problem;
    problem.stiffness = 1e5;
    problem.dt = dt;
    problem.method = method;
    return problem;
}

}  // namespace

TEST_CASE("prediction: a number is written down")
{
    expect_that("the predicted factor is a positive number",
                predicted_factor() > 0 && std::isfinite(predicted_factor()));
}

TEST_CASE(
    "measurement: a continuous bounce with steps of 0.01 ms loses the half per cent that half a swing of its damper takes")
{
    // c = k dt / 2 = 0.5 N s/m, critical is 632 N s/m: exp(-2 pi 0.000791) = 0.99504. Gravity makes the
    // contact longer, by a hundredth.
    given("1 kg from 1 m, k 100 000 N/m, dt 0.01 ms, continuous");
    expect("lost part of the height", 100 * lost_by_a_bounce(bounce(1e-5), 1), 0.4957, 0.02, "%");
}

TEST_CASE("measurement: the discrete method loses twice as much")
{
    given("1 kg from 1 m, k 100 000 N/m, dt 0.01 ms");
    const double ratio = lost_by_a_bounce(bounce(1e-5, PenaltyMethod::discrete), 1) /
                         lost_by_a_bounce(bounce(1e-5), 1);
    expect("loss of the discrete over that of the continuous method", ratio, 2.0, 0.05);
}

TEST_CASE("law: the loss is one minus the square of the kept speed")
{
    for (const double dt : {1e-5, 1e-3}) {
        given("1 kg, k 100 000 N/m, dt ", dt, " s, continuous");
        const double ratio = 0.25 * std::sqrt(1e5) * dt;
        const double per_swing = std::numbers::pi * ratio / std::sqrt(1 - ratio * ratio);
        expect("lost part of the height", 100 * law_of_loss(bounce(dt)), 100 * (1 - std::exp(-2 * per_swing)),
               1e-9, "%");
    }
    given("1 kg, k 100 000 N/m, dt 0.001 s, discrete");
    const double ratio = 0.5 * std::sqrt(1e5) * 1e-3;
    expect("lost part of the height", 100 * law_of_loss(bounce(1e-3, PenaltyMethod::discrete)),
           100 * (1 - std::exp(-2 * std::numbers::pi * ratio / std::sqrt(1 - ratio * ratio))), 1e-9, "%");
}

TEST_CASE("law: measurement and law agree for short steps")
{
    for (const double dt : {4e-5, 1e-5}) {
        given("1 kg from 1 m, k 100 000 N/m, dt ", dt, " s, continuous");
        const double measured = lost_by_a_bounce(bounce(dt), 1), law = law_of_loss(bounce(dt));
        expect("measured over law", measured / law, 1.0, 0.03);
        say("dt ", 1000 * dt, " ms: lost ", 100 * measured, " % of the height, by the law ", 100 * law, " %");
    }
}

TEST_CASE("factor: a quarter of the step loses a quarter of the height")
{
    given("1 kg from 1 m, k 100 000 N/m, dt 0.04 ms and 0.01 ms, continuous");
    const double measured = measured_factor(bounce(4e-5), 1);
    expect("loss over loss", measured, 4.0, 0.1);
    say("a quarter of the step loses ", measured, " times less");
    say("you predicted ", predicted_factor());
}

}  // namespace enduring
