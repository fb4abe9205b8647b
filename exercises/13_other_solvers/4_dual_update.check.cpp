#include "exercises/13_other_solvers/4_dual_update.hpp"
#include "exercises/checking.hpp"

#include <cmath>

using namespace enduring;

TEST_CASE("dual: inside, the multiplier becomes the force and the stiffness grows by the error")
{
    given("30 N, 1000 N/m, 2 cm inside, beta 500 N/m^2");
    const AugmentedContact after = dual_update({30, 1000}, 0.02, 500);
    expect("multiplier", after.multiplier, 50, 1e-12, "N");
    expect("stiffness", after.stiffness, 1010, 1e-12, "N/m");
}

TEST_CASE("dual: what is outside by a little pushes less, and its stiffness grows, too")
{
    given("30 N, 1000 N/m, 1 cm outside, beta 500 N/m^2");
    const AugmentedContact after = dual_update({30, 1000}, -0.01, 500);
    expect("multiplier", after.multiplier, 20, 1e-12, "N");
    expect("stiffness", after.stiffness, 1005, 1e-12, "N/m");
}

TEST_CASE("dual: no contact pulls, and one that is open keeps its stiffness")
{
    given("30 N, 1000 N/m, 5 cm outside, beta 500 N/m^2");
    const AugmentedContact after = dual_update({30, 1000}, -0.05, 500);
    expect("multiplier", after.multiplier, 0, 1e-14, "N");
    expect("stiffness", after.stiffness, 1000, 1e-12, "N/m");
}

TEST_CASE("primal: above the floor a block falls")
{
    given("2 kg, 1 m above the floor, 3 m/s upwards, dt 0.01 s");
    expect("height", primal_update({2, 1, 3}, {0, 1000}, 0.01), 1 + 0.03 - 9.81e-4, 1e-12, "m");
}

TEST_CASE("primal: the block ends where inertia and contact are in balance")
{
    for (const double multiplier : {0.0, 50.0}) {
        const double m = 5, k = 2e4, dt = 0.01;
        given("5 kg, 1 cm inside, 0.2 m/s downwards, ", multiplier, " N and 20000 N/m");
        const double x = primal_update({m, -0.01, -0.2}, {multiplier, k}, dt);
        const double y = -0.01 - 0.2 * dt - 9.81 * dt * dt;
        expect("what is missing", m / (dt * dt) * (x - y) - (multiplier - k * x), 0, 1e-8, "N");
    }
}

TEST_CASE("primal: a contact that would pull does nothing")
{
    given("1 kg, 0.1 m above the floor, at rest, 10 N and 1000 N/m");
    expect("height", primal_update({1, 0.1, 0}, {10, 1000}, 0.01), 0.1 - 9.81e-4, 1e-12, "m");
}

TEST_CASE("sweeps: with the right multiplier one sweep ends on the floor")
{
    given("3 kg at rest on the floor, the multiplier is the weight");
    AugmentedContact contact{3 * 9.81, 100};
    expect("height", step_height({3, 0, 0}, contact, 0, 0.01, 1), 0, 1e-14, "m");
    expect("multiplier", contact.multiplier, 3 * 9.81, 1e-11, "N");
}

TEST_CASE("sweeps: each leaves the same part of the multiplier's error where the stiffness stays")
{
    for (const double stiffness : {1e3, 1e4, 1e5}) {
        const double m = 10, dt = 0.01, weight = m * 9.81;
        AugmentedContact once{0, stiffness}, twice{0, stiffness};
        step_height({m, 0, 0}, once, 0, dt, 1);
        step_height({m, 0, 0}, twice, 0, dt, 2);
        given("10 kg on the floor, ", stiffness, " N/m, no multiplier at first");
        expect("part after one sweep", (weight - once.multiplier) / weight, part_left(m, stiffness, dt),
               1e-10, "");
        expect("part after two", (weight - twice.multiplier) / weight,
               std::pow(part_left(m, stiffness, dt), 2), 1e-10, "");
    }
    say("10 kg, 10 ms, 1e5 N/m: each sweep leaves ", 100 * part_left(10, 1e5, 0.01), " %");
}

TEST_CASE("sweeps: a stiffness that grows leaves less than one that stays")
{
    given("10 kg on the floor, 1000 N/m at first, 20 sweeps");
    AugmentedContact stays{0, 1e3}, grows{0, 1e3};
    const double still = step_height({10, 0, 0}, stays, 0, 0.01, 20),
                 grown = step_height({10, 0, 0}, grows, 1e8, 0.01, 20);
    expect_that("the depth is less than half", -grown < -still / 2 && grown <= 0);
    expect_that("the stiffness has grown", grows.stiffness > 2e3);
}
