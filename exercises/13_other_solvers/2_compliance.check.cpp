#include "exercises/13_other_solvers/2_compliance.hpp"
#include "exercises/checking.hpp"

#include <cmath>

using namespace enduring;

TEST_CASE("multiplier: without compliance the whole error goes, with much of it nearly none")
{
    given("error -0.02 m, response 0.5 / kg, compliance 0");
    expect("change", multiplier_change(-0.02, 0, 0.5, 0, 0.01), 0.04, 1e-14, "kg m");
    given("the same with a compliance of 5e-5 m/N and dt 0.01 s, which counts as much as the response");
    expect("change", multiplier_change(-0.02, 0, 0.5, 5e-5, 0.01), 0.02, 1e-14, "kg m");
    given("and with half the substep");
    expect("change", multiplier_change(-0.02, 0, 0.5, 5e-5, 0.005), 0.008, 1e-14, "kg m");
}

TEST_CASE("multiplier: what is reached is left alone")
{
    for (const double compliance : {1e-6, 1e-4})
        for (const double dt : {0.001, 0.01}) {
            const double error = -0.03, response = 0.25;
            const double first = multiplier_change(error, 0, response, compliance, dt);
            given("compliance ", compliance, " m/N, dt ", dt, " s: after the first change ", first, " kg m");
            expect("second change",
                   multiplier_change(error + response * first, first, response, compliance, dt), 0, 1e-13,
                   "kg m");
        }
}

TEST_CASE("substep: above the floor a block falls")
{
    given("1 m above the floor, 2 m/s upwards, dt 0.01 s");
    const BlockOnFloor after = substep({3, 1, 2}, 1e-5, 0.01, 4);
    expect("velocity", after.velocity, 2 - 0.0981, 1e-12, "m/s");
    expect("height", after.height, 1 + 0.01 * (2 - 0.0981), 1e-13, "m");
}

TEST_CASE("substep: on a floor without compliance a block ends on the floor, not deeper and not higher")
{
    given("2 kg, 1 mm above the floor, comes with 1 m/s, dt 0.01 s");
    const BlockOnFloor after = substep({2, 1e-3, -1}, 0, 0.01, 1);
    expect("height", after.height, 0, 1e-15, "m");
    expect("velocity", after.velocity, -0.1, 1e-12, "m/s");
}

TEST_CASE("substep: one with compliance is the implicit step of a spring, however many corrections")
{
    for (const double compliance : {1e-6, 1e-4, 1e-2})
        for (const int iterations : {1, 2, 10}) {
            const double m = 4, dt = 0.005, k = 1 / compliance;
            const BlockOnFloor block{m, -0.01, 0.3};
            given("4 kg, 1 cm deep, 0.3 m/s upwards, compliance ", compliance, " m/N, ", iterations,
                  " corrections");
            const double velocity = (block.velocity - 9.81 * dt - dt * k / m * block.height) /
                                    (1 + dt * dt * k / m);
            const BlockOnFloor after = substep(block, compliance, dt, iterations);
            expect("velocity", after.velocity, velocity, 1e-9, "m/s");
            expect("height", after.height, block.height + dt * velocity, 1e-12, "m");
        }
}

TEST_CASE("spring: its step meets its own equation, and is the substep of XPBD")
{
    for (const double compliance : {1e-6, 1e-4, 1e-2}) {
        const double m = 4, dt = 0.005;
        const BlockOnFloor block{m, -0.01, 0.3};
        given("4 kg, 1 cm deep, 0.3 m/s upwards, compliance ", compliance, " m/N");
        const double after = implicit_velocity(block, compliance, dt);
        const double force = -(block.height + dt * after) / compliance - 9.81 * m;
        expect("velocity", after, block.velocity + dt * force / m, 1e-9, "m/s");
        expect("velocity of the substep", substep(block, compliance, dt, 1).velocity, after, 1e-9, "m/s");
    }
}

TEST_CASE("rest: a block that starts at the depth of rest stays, for every substep")
{
    for (const double dt : {1e-4, 1e-3, 1e-2}) {
        given("10 kg, compliance 1e-5 m/N, dt ", dt, " s");
        BlockOnFloor block{10, -rest_depth(10, 1e-5), 0};
        for (int i = 0; i < 20; ++i)
            block = substep(block, 1e-5, dt, 1);
        expect("depth", -block.height, 9.81e-4, 1e-12, "m");
    }
    say("10 kg at a compliance of 1e-5 m/N: ", 1e3 * rest_depth(10, 1e-5), " mm deep");
}

TEST_CASE("compliance: four contacts under a cube carry a quarter of it each")
{
    given("10 kg on four contacts, 1 mm deep");
    const double compliance = compliance_for(10, 4, 1e-3);
    expect("depth under a quarter of the mass", rest_depth(10 / 4.0, compliance), 1e-3, 1e-13, "m");
    expect("compliance", compliance, 4e-3 / 98.1, 1e-13, "m/N");
}
