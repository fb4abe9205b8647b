#include "exercises/01_particle_plane/2_restitution.hpp"
#include "exercises/checking.hpp"

#include <cmath>
#include <numbers>

namespace enduring {
namespace {

/// Number with two digits, as the page shows it.
double two_digits(double value) { return std::round(100 * value) / 100; }

}  // namespace

TEST_CASE("damper: without a spring its impulse is c times the way inside, upwards while the particle sinks")
{
    given("depth from -0.01 m to -0.03 m, k 0, c 5 N s/m, dt 0.01 s");
    expect("impulse", damped_plane_impulse(-0.01, -0.03, 0, 5, 0.01), 0.1, 1e-15, "N s");
    given("depth from -0.03 m to -0.01 m, k 0, c 5 N s/m, dt 0.01 s");
    expect("impulse", damped_plane_impulse(-0.03, -0.01, 0, 5, 0.01), -0.1, 1e-15, "N s");
}

TEST_CASE("damper: only the way inside counts")
{
    given("depth from 0.03 m to -0.01 m, k 0, c 5 N s/m, dt 0.01 s");
    expect("impulse", damped_plane_impulse(0.03, -0.01, 0, 5, 0.01), 0.05, 1e-15, "N s");
    given("depth from 0.03 m to 0.01 m");
    expect("impulse", damped_plane_impulse(0.03, 0.01, 0, 5, 0.01), 0.0, 0, "N s");
}

TEST_CASE("leaving: a step that begins inside counts up to where it crosses")
{
    given("depth from -0.01 m to 0.03 m, k 1000 N/m, c 0, dt 0.01 s");
    expect("impulse", damped_plane_impulse(-0.01, 0.03, 1000, 0, 0.01), 0.0125, 1e-15, "N s");
    given(
        "depth from -0.01 m to 0.03 m, k 1000 N/m, c 5 N s/m, dt 0.01 s: the damper pulls more than the spring pushes");
    expect("impulse", damped_plane_impulse(-0.01, 0.03, 1000, 5, 0.01), 0.0125 - 0.05, 1e-15, "N s");
}

TEST_CASE("size: at twice the speed the impulse is twice as large, from micrometres a step to kilometres")
{
    for (const double size : {1e-6, 1e-3, 1.0, 1e3}) {
        given("depth from ", 3 * size, " m to ", -size, " m, k 800 N/m, c 5 N s/m, dt 0.25 s");
        // A quarter of the step, and half the depth on average: 800 * 0.25 / 8 for the spring.
        expect("impulse", damped_plane_impulse(3 * size, -size, 800, 5, 0.25), (25 + 5) * size, 1e-12 * size,
               "N s");
    }
}

TEST_CASE("spring: without a damper the impulse is the area under the depth")
{
    given("depth from 0.02 m to -0.02 m, k 1000 N/m, c 0, dt 0.01 s");
    expect("impulse", damped_plane_impulse(0.02, -0.02, 1000, 0, 0.01), 0.05, 1e-15, "N s");
}

TEST_CASE("restitution: with the step's own damper the swing loses just what was asked")
{
    const double mass = 0.3, k = 700, dt = 1e-3;
    for (const double restitution : {0.9, 0.5, 0.2}) {
        given("restitution ", restitution, ", mass 0.3 kg, k 700 N/m, dt 0.001 s");
        const double c = damper_for_restitution(restitution, mass, k, dt) + 0.5 * k * dt;
        const double ratio = c / (2 * std::sqrt(k * mass));
        expect("exp(-pi zeta / sqrt(1 - zeta^2)) of your damper and the step's together",
               std::exp(-std::numbers::pi * ratio / std::sqrt(1 - ratio * ratio)), restitution,
               1e-6);  // pi to five digits is enough
    }
}

TEST_CASE("restitution: where the step damps too much already, nothing is added")
{
    given("restitution 1, mass 1 kg, k 1000 N/m, dt 0.01 s");
    expect("c", damper_for_restitution(1, 1, 1000, 0.01), 0.0, 0, "N s/m");
}

TEST_CASE("bounce: a short step keeps the speed that was asked for")
{
    const double mass = 2, k = 5000, dt = 1e-5;
    for (const double restitution : {0.9, 0.5, 0.2}) {
        given("restitution ", restitution, ", mass 2 kg, k 5000 N/m, dt 1e-5 s, 3 m/s");
        const double kept = kept_by_a_bounce(3, mass, k, damper_for_restitution(restitution, mass, k, dt),
                                             dt);
        expect("part of the speed that is kept", kept, restitution, 2e-3);
        say("wanted ", restitution, " of the speed, kept ", two_digits(kept));
    }
}

// The way of the next bounces is known in closed form. With a = k dt^2 / m and v = dt = 1 the first height is
// 1/2, the first step takes v to -1 + a/8, and so on; all numbers are fractions.
TEST_CASE("bounce: with a = k dt^2 / m = 2 it lasts two steps and keeps half of the speed")
{
    for (const double speed : {1e-3, 1.0, 1e3}) {
        given("mass 4 kg, k 512 N/m, c 0, dt 0.125 s, ", speed, " m/s: heights 1/2, -1/4 and 1/4 of v dt");
        expect("part of the speed that is kept", kept_by_a_bounce(speed, 4, 512, 0, 0.125), 0.5, 1e-12);
    }
}

TEST_CASE("bounce: with a = k dt^2 / m = 1 the step in which it leaves pushes, too")
{
    given(
        "mass 1 kg, k 64 N/m, c 0, dt 0.125 s, 1 m/s: heights 1/2, -3/8, -7/16, -1/32 of v dt, then outside");
    expect("part of the speed that is kept", kept_by_a_bounce(1, 1, 64, 0, 0.125), 339 / 832.0, 1e-12);
}

TEST_CASE("bounce: with a = k dt^2 / m = 6 it is outside and still sinks, and goes on")
{
    given("mass 1 kg, k 384 N/m, c 0, dt 0.125 s, 1 m/s: heights 1/2, 1/4 (sinking), 0 and 1/2 of v dt");
    expect("part of the speed that is kept", kept_by_a_bounce(1, 1, 384, 0, 0.125), 0.5, 1e-12);
}

TEST_CASE("bounce: without a damper of your own a long step still loses speed, as chapter 1 found")
{
    given("mass 1 kg, k 1000 N/m, c 0, dt 0.01 s, 1 m/s");
    const double ratio = 0.5 * 1000 * 0.01 / (2 * std::sqrt(1000.0));
    expect("part of the speed that is kept", kept_by_a_bounce(1, 1, 1000, 0, 0.01),
           std::exp(-std::numbers::pi * ratio), 0.04);
}

}  // namespace enduring
