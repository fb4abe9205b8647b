#include "exercises/01_particle_plane/4_what_a_bounce_costs.hpp"
#include "exercises/checking.hpp"

#include <algorithm>
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

/// The greatest height after the first contact, looked at in every step.
double watched_top(const ParticleProblem& problem, double height)
{
    ParticleState state{height, 0};
    double lowest = height;
    while (lowest > 0 || state.velocity < 0 || state.height < 0) {
        state = step(state, problem);
        lowest = std::min(lowest, state.height);
    }
    for (ParticleState next = step(state, problem); next.height > state.height; next = step(state, problem))
        state = next;
    return state.height;
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

TEST_CASE(
    "measurement: neither the height nor gravity matters, and a heavy particle loses less, as the law says")
{
    for (const double height : {0.5, 9.0})
        for (const double mass : {0.25, 4.0})
            for (const double gravity : {1.62, 9.81}) {
                ParticleProblem problem = bounce(1e-5);
                problem.mass = mass;
                problem.gravity = gravity;
                given(mass, " kg from ", height, " m, g ", gravity,
                      " m/s^2, k 100 000 N/m, dt 0.01 ms, continuous");
                const double per_swing = std::numbers::pi * 0.25 * std::sqrt(1e5 / mass) * 1e-5;
                expect("lost part of the height over that of half a swing",
                       lost_by_a_bounce(problem, height) / (1 - std::exp(-2 * per_swing)), 1.0, 0.03);
            }
}

TEST_CASE("measurement: with a long step it depends on the height where the step meets the ground")
{
    for (const double height : {2.0, 4.0, 9.0}) {
        const ParticleProblem problem = bounce(1e-3);
        given("1 kg from ", height, " m, k 100 000 N/m, dt 1 ms, continuous");
        expect("lost part of the height", 100 * lost_by_a_bounce(problem, height),
               100 * (1 - watched_top(problem, height) / height), 0.2, "%");
    }
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

TEST_CASE("law: only k dt^2 / m counts, so four times the mass is half the step")
{
    for (const double mass : {0.25, 4.0}) {
        ParticleProblem problem = bounce(1e-3);
        problem.mass = mass;
        given(mass, " kg, k 100 000 N/m, dt 0.001 s, continuous");
        expect("lost part of the height, as for 1 kg with 0.001 s over the root of the mass",
               100 * law_of_loss(problem), 100 * law_of_loss(bounce(1e-3 / std::sqrt(mass))), 1e-9, "%");
    }
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

TEST_CASE("factor: it is measured, for any particle, height, method and step")
{
    for (const double height : {0.5, 2.0})
        for (const double dt : {0.001, 0.004}) {
            ParticleProblem problem = bounce(dt, PenaltyMethod::discrete), quarter;
            problem.mass = 3;
            quarter = problem;
            quarter.dt = dt / 4;
            given("3 kg from ", height, " m, k 100 000 N/m, dt ", dt, " s and a quarter of it, discrete");
            expect("loss over loss", measured_factor(problem, height),
                   lost_by_a_bounce(problem, height) / lost_by_a_bounce(quarter, height), 1e-9);
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
