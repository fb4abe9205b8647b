#include "exercises/13_other_solvers/5_barrier_gradient.hpp"
#include "exercises/checking.hpp"

#include <cmath>

using namespace enduring;

TEST_CASE("barrier: by hand, halfway")
{
    given("distance 1 mm, d_hat 2 mm");
    expect("barrier", barrier(1e-3, 2e-3), 1e-6 * std::log(2.0), 1e-18, "m^2");
    expect("slope", barrier_slope(1e-3, 2e-3), -1e-3 * (2 * std::log(2.0) + 1), 1e-15, "m");
}

TEST_CASE("barrier: nothing from d_hat on, and more than any bound near the floor")
{
    given("d_hat 2 mm");
    expect("barrier at d_hat", barrier(2e-3, 2e-3), 0, 1e-18, "m^2");
    expect("barrier beyond", barrier(5e-3, 2e-3), 0, 1e-18, "m^2");
    expect("slope beyond", barrier_slope(5e-3, 2e-3), 0, 1e-18, "m");
    expect_that("1e-12 m before the floor the slope is steeper than 1000 m",
                barrier_slope(1e-12, 2e-3) < -1e3);
}

TEST_CASE("slope: it is that of the barrier")
{
    for (const double part : {0.01, 0.2, 0.7, 0.99}) {
        const double d_hat = 3e-3, d = part * d_hat, h = 1e-6 * d;
        given("distance ", part, " d_hat");
        const double measured = (barrier(d + h, d_hat) - barrier(d - h, d_hat)) / (2 * h);
        expect("slope", barrier_slope(d, d_hat), measured, 1e-6 * std::abs(measured) + 1e-9, "m");
    }
}

TEST_CASE("rest: the barrier carries the load")
{
    for (const double load : {1.0, 100.0, 1e5}) {
        given("a load of ", load, " N on a barrier of 1e5 N/m and 1 mm");
        const double d = rest_distance(load, 1e5, 1e-3);
        expect_that("the distance is between 0 and d_hat", d > 0 && d < 1e-3);
        expect("force", -1e5 * barrier_slope(d, 1e-3), load, 1e-5 * load, "N");
    }
    say("100 N on 1e5 N/m and 1 mm: ", 1e6 * rest_distance(100, 1e5, 1e-3), " um");
}

TEST_CASE("free part: a step that meets nothing is taken in full")
{
    given("1 cm above the floor, 5 mm down; and upwards");
    expect("part", free_part(0.01, -0.005), 1, 1e-14, "");
    expect("part upwards", free_part(0.01, 0.5), 1, 1e-14, "");
}

TEST_CASE("free part: one that would meet the floor goes 0.8 of the distance")
{
    given("1 cm above the floor, 4 cm down");
    expect("part", free_part(0.01, -0.04), 0.2, 1e-14, "");
    given("1 cm above the floor, exactly 1 cm down");
    expect("part", free_part(0.01, -0.01), 0.8, 1e-14, "");
}

TEST_CASE("step: without a barrier in reach the block goes where inertia brings it")
{
    given("2 kg, 1 m above the floor, on to 0.9 m");
    expect("height", step_end({2, 1, 0.9}, 1e5, 1e-3, 0.01), 0.9, 1e-9, "m");
}

TEST_CASE("step: it ends above the floor in balance, however far below inertia would bring it")
{
    for (const double falls_to : {0.5e-3, -1e-3, -0.5, -50.0}) {
        const double m = 2, dt = 0.01, kappa = 1e5, d_hat = 1e-3;
        given("2 kg, 1 cm above the floor, inertia brings it to ", falls_to, " m");
        const double x = step_end({m, 0.01, falls_to}, kappa, d_hat, dt);
        expect_that("above the floor", x > 0);
        const double inertia = m / (dt * dt) * (x - falls_to);
        expect("inertia and barrier", inertia + kappa * barrier_slope(x, d_hat), 0, 1e-5 * inertia, "N");
    }
}
