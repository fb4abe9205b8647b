#include "exercises/13_other_solvers/3_soft_contact.hpp"
#include "exercises/checking.hpp"

#include <cmath>
#include <numbers>

using namespace enduring;

namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

TEST_CASE("implicit step: it meets its own equation")
{
    for (const double hertz : {1.0, 30.0, 300.0})
        for (const double zeta : {0.0, 1.0, 10.0}) {
            const double h = 0.0025, x = -0.01, v = 0.3, omega = 2 * pi * hertz;
            const double after = implicit_speed(hertz, zeta, h, x, v);
            given("hertz ", hertz, ", damping ratio ", zeta, ", h 0.0025 s, 1 cm deep, 0.3 m/s");
            const double force = -omega * omega * (x + h * after) - 2 * zeta * omega * after;
            expect("speed after", after, v + h * force, 1e-10 * (1 + std::abs(h * omega * omega * x)), "m/s");
        }
}

TEST_CASE("numbers: those of 30 hertz and ten times critical in a substep of 2.5 ms")
{
    const SoftNumbers soft = soft_numbers(30, 10, 0.0025);
    given("omega 60 pi / s, a1 = 20 + 0.15 pi, a2 = 0.15 pi a1");
    const double a1 = 20 + 0.15 * pi, a2 = 0.15 * pi * a1;
    expect("bias rate", soft.bias_rate, 60 * pi / a1, 1e-10, "1/s");
    expect("mass scale", soft.mass_scale, a2 / (1 + a2), 1e-12, "");
    expect("impulse scale", soft.impulse_scale, 1 / (1 + a2), 1e-12, "");
    say("30 hertz, ten times critical: a depth goes by ", soft.bias_rate,
        " of itself a second, and is halved in ", time_to_part(soft, 0.5), " s");
}

TEST_CASE("change: a row that is solved until nothing changes ends at the implicit step, whatever the mass")
{
    for (const double mass : {0.1, 1.0, 50.0})
        for (const double hertz : {5.0, 60.0}) {
            const double h = 0.0025, x = -0.01, v = -0.2;
            const SoftNumbers soft = soft_numbers(hertz, 2, h);
            double sum = 0, speed = v;
            for (int i = 0; i < 5000; ++i) {
                const double change = change_of_impulse(soft, mass, x, speed, sum);
                sum += change;
                speed += change / mass;
            }
            given("mass ", mass, " kg, ", hertz, " hertz");
            expect("speed", speed, implicit_speed(hertz, 2, h, x, v), 1e-9, "m/s");
        }
}

TEST_CASE("change: the sum never pulls")
{
    const SoftNumbers soft = soft_numbers(30, 10, 0.0025);
    given("2 kg that leave with 5 m/s, and have been pushed by 3 N s");
    expect("change", change_of_impulse(soft, 2, 0, 5, 3), -3, 1e-12, "N s");
    given("the same, not pushed yet");
    expect("change", change_of_impulse(soft, 2, 0, 5, 0), 0, 1e-12, "N s");
}

TEST_CASE("substeps: above the floor a mass falls, and none ends below it")
{
    given("2 kg, 1 m above the floor, 3 m/s upwards, dt 0.01 s in 4 substeps");
    const FallingMass free = soft_step({2, 1, 3}, 30, 10, 0.01, 4);
    expect("velocity", free.velocity, 3 - 0.0981, 1e-12, "m/s");
    expect("height", free.height, 1 + 0.03 - 9.81 * 0.0025 * 0.0025 * 10, 1e-12, "m");
    for (const double height : {1e-4, 3e-3, 8e-3}) {
        given("5 kg, ", 1e3 * height, " mm above the floor, 1 m/s downwards, dt 0.01 s in 1 substep");
        const FallingMass landed = soft_step({5, height, -1}, 30, 10, 0.01, 1);
        expect("height", landed.height, 0, 1e-12, "m");
        expect("velocity", landed.velocity, 0, 1e-12, "m/s");
    }
}

TEST_CASE("substeps: a mass that starts inside rises by the bias, and relax leaves it no speed")
{
    for (const double mass : {0.1, 50.0})
        for (const int substeps : {1, 4}) {
            const double dt = 0.01, depth = 0.01, h = dt / substeps;
            const SoftNumbers soft = soft_numbers(60, 10, h);
            given("mass ", mass, " kg, 1 cm deep, 60 hertz, ", substeps, " substeps in 0.01 s");
            double inside = depth;
            for (int i = 0; i < substeps; ++i)  // of the gravity of a substep, the row leaves a part
                inside -= h * (soft.mass_scale * soft.bias_rate * inside - (1 - soft.mass_scale) * 9.81 * h);
            const FallingMass after = soft_step({mass, -depth, 0}, 60, 10, dt, substeps);
            expect("height", after.height, -inside, 1e-12, "m");
            expect("velocity", after.velocity, 0, 1e-12, "m/s");
        }
}

TEST_CASE("time: an eighth takes three times as long as a half")
{
    const SoftNumbers soft{4, 0.9, 0.1};
    given("bias rate 4 / s");
    expect("half", time_to_part(soft, 0.5), std::log(2.0) / 4, 1e-13, "s");
    expect("an eighth", time_to_part(soft, 0.125), 3 * std::log(2.0) / 4, 1e-13, "s");
}
