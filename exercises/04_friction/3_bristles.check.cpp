#include "exercises/04_friction/3_bristles.hpp"
#include "exercises/checking.hpp"

#include <cmath>

namespace enduring {
namespace {

const Bristles brush{1000, 1};  // 1000 N/m, 1 N: fully bent at 1 mm

/// The same step in a million pieces of explicit Euler, its impulse by the trapezoidal rule.
BristleStep many_pieces(double bend, double velocity, double dt)
{
    const int pieces = 1000000;
    const double h = dt / pieces;
    double impulse = 0;
    for (int i = 0; i < pieces; ++i) {
        const double next = bend + h * (velocity - brush.stiffness * std::abs(velocity) / brush.limit * bend);
        impulse -= 0.5 * h * brush.stiffness * (bend + next);
        bend = next;
    }
    return {bend, impulse};
}

}  // namespace

TEST_CASE("step: a short way bends the bristles by that way, and they pull back like a spring")
{
    given("stiffness 1000 N/m, limit 1 N, unbent, 1 um in 1 ms");
    const BristleStep step = bend_bristles(brush, 0, 1e-3, 1e-3);
    expect("bend", 1e6 * step.bend, 1.0, 2e-3, "um");
    expect("impulse", 1e6 * step.impulse, -0.5, 2e-3, "uN s");
}

TEST_CASE("step: the shorter the way, the more exactly the bristles are a spring")
{
    for (const double way : {1e-7, 1e-10, 1e-13}) {
        given("stiffness 1000 N/m, limit 1 N, unbent, ", way, " m in 1 ms");
        const BristleStep step = bend_bristles(brush, 0, way / 1e-3, 1e-3);
        expect("bend over way", step.bend / way, 1.0, 1e-4);
        expect("impulse over half of stiffness, way and time", step.impulse / (0.5 * 1000 * way * 1e-3), -1.0,
               1e-4);
    }
}

TEST_CASE("step: only the way counts, over the full bend: not the speed, and not which brush it is")
{
    for (const double stiffness : {50.0, 4e5})
        for (const double limit : {0.3, 200.0})
            for (const double speed : {1e-8, 1e-2, 1e5})
                for (const double ways : {-2.5, 1e-3, 0.7}) {
                    const double full = limit / stiffness;  // m
                    const double velocity = std::copysign(speed, ways), dt = std::abs(ways) * full / speed;
                    given("stiffness ", stiffness, " N/m, limit ", limit, " N, bend 0.6 of the full one, ",
                          velocity, " m/s for ", ways, " full bends");
                    const BristleStep step = bend_bristles({stiffness, limit}, 0.6 * full, velocity, dt),
                                      same = bend_bristles(brush, 6e-4, std::copysign(1.0, ways),
                                                           std::abs(ways) * 1e-3);
                    expect("bend over the full one, as of 1000 N/m and 1 N at 1 m/s", step.bend / full,
                           same.bend / 1e-3, 1e-6);
                    expect("impulse over limit and time, as of 1000 N/m and 1 N at 1 m/s",
                           step.impulse / (limit * dt), same.impulse / (std::abs(ways) * 1e-3), 1e-6);
                }
}

TEST_CASE("step: after a long way friction is the limit, against the velocity")
{
    for (const double velocity : {2.0, -2.0}) {
        given("stiffness 1000 N/m, limit 1 N, ", velocity, " m/s for 10 s");
        const BristleStep step = bend_bristles(brush, 0, velocity, 10);
        expect("bend", 1000 * step.bend, velocity / 2, 1e-12, "mm");
        // Of the way of 10 s one full bend, 1 mm, goes into the bristles.
        expect("impulse", step.impulse, -std::copysign(10 - 1e-3 / 2, velocity), 1e-4, "N s");
    }
}

TEST_CASE("step: it is what a million pieces add up to")
{
    for (const double bend : {0.0, 8e-4, -5e-4, 2.5e-3}) {
        given("bend ", bend, " m, 0.05 m/s, dt 0.02 s");
        const BristleStep step = bend_bristles(brush, bend, 0.05, 0.02), fine = many_pieces(bend, 0.05, 0.02);
        expect("bend", 1000 * step.bend, 1000 * fine.bend, 1e-5, "mm");
        expect("impulse", 1000 * step.impulse, 1000 * fine.impulse, 1e-4, "mN s");
    }
}

TEST_CASE("step: one step is two steps of half its length")
{
    given("bend -0.0004 m, -0.03 m/s, dt 0.05 s");
    const BristleStep first = bend_bristles(brush, -4e-4, -0.03, 0.025),
                      second = bend_bristles(brush, first.bend, -0.03, 0.025);
    const BristleStep whole = bend_bristles(brush, -4e-4, -0.03, 0.05);
    expect("bend", 1000 * whole.bend, 1000 * second.bend, 1e-9, "mm");
    expect("impulse", 1000 * whole.impulse, 1000 * (first.impulse + second.impulse), 1e-6, "mN s");
}

TEST_CASE("step: at rest the bristles stay bent and hold")
{
    given("bend 0.0005 m, at rest, dt 0.01 s");
    const BristleStep step = bend_bristles(brush, 5e-4, 0, 0.01);
    expect("bend", 1000 * step.bend, 0.5, 1e-15, "mm");
    expect("impulse", 1000 * step.impulse, -5.0, 1e-12, "mN s");
}

TEST_CASE("step: at a speed of next to nothing they hold as at rest, to the last digits")
{
    for (const double velocity : {1e-17, 1e-20}) {
        given("bend 0.0005 m, ", velocity, " m/s, dt 0.01 s");
        const BristleStep step = bend_bristles(brush, 5e-4, velocity, 0.01);
        expect("bend", 1000 * step.bend, 0.5, 1e-12, "mm");
        expect("impulse", 1000 * step.impulse, -5.0, 1e-9, "mN s");
    }
}

TEST_CASE("cycle: a long way costs Coulomb's four amplitudes, a short one far less")
{
    double lost[2];
    int i = 0;
    for (const double amplitude : {0.1, 1e-4}) {
        given("amplitude ", amplitude, " m, 0.2 m/s, stiffness 1000 N/m, limit 1 N");
        lost[i] = loss_per_cycle(brush, amplitude, 0.2, 200);
        say("amplitude ", 1000 * amplitude, " mm: ", lost[i++], " J a cycle, Coulomb's law says ",
            4 * amplitude, " J");
    }
    // In the steady cycle a half begins at the bend -b and ends at b = z
    // tanh(A/z), z = 1 mm: the loss is 4 A f - 4 f z tanh(A/z).
    expect("loss at 100 mm", lost[0], 0.4 - 0.004 * std::tanh(100.0), 1e-5, "J");
    expect("loss at 0.1 mm over Coulomb's", lost[1] / 4e-4, 1 - std::tanh(0.1) / 0.1, 1e-6);
}

TEST_CASE("cycle: the loss is that of any brush, whatever the speed and the number of steps")
{
    const double stiffness = 4e4, limit = 0.3, full = limit / stiffness;
    for (const double speed : {0.03, 5.0})
        for (const int steps : {20, 300})
            for (const double ways : {0.5, 3.0}) {
                given("amplitude ", ways * full, " m, ", speed, " m/s, ", steps, " steps a way, stiffness ",
                      stiffness, " N/m, limit ", limit, " N");
                const double lost = loss_per_cycle({stiffness, limit}, ways * full, speed, steps);
                expect("loss over Coulomb's", lost / (4 * ways * full * limit), 1 - std::tanh(ways) / ways,
                       1e-5);
            }
}

}  // namespace enduring
