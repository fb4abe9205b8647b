#include "exercises/09_deep_contacts/4_lift.hpp"
#include "exercises/checking.hpp"

#include <cmath>

using namespace enduring;

namespace {

ImplicitParticle particle_of(double mass, double stiffness, double dt, PositionUpdate update)
{
    ImplicitParticle particle;
    particle.mass = mass;
    particle.stiffness = stiffness;
    particle.dt = dt;
    particle.update = update;
    return particle;
}

/// With the spring of the rest offset; `energy` knows the spring of a ground at 0 only.
double energy_of(const LettingOut& out, const ImplicitParticle& particle)
{
    const double compression = std::min(0.0, out.state.height - out.rest_offset);
    return particle.mass *
               (out.state.velocity * out.state.velocity / 2 + particle.gravity * out.state.height) +
           particle.stiffness * compression * compression / 2;
}

std::string told(const Fade& fade) { return in_words("keep ", fade.keep, ", speed ", fade.speed, " m/s"); }

int steps_one_by_one(double rest_offset, double left, const Fade& fade, double dt)
{
    int steps = 0;
    for (; rest_offset <= -left; ++steps)
        rest_offset = faded(rest_offset, fade, dt);
    return steps;
}

}  // namespace

TEST_CASE("prediction: it is a number of seconds")
{
    expect_that("the seconds are positive and finite",
                predicted_seconds() > 0 && std::isfinite(predicted_seconds()));
}

TEST_CASE("faded: deep inside it fades by the speed, near the surface by a part")
{
    const Fade fade;
    given("keep 0.9, speed 0.25 m/s, dt 0.01 s");
    expect("rest offset after -0.5 m", faded(-0.5, fade, 0.01), -0.4975, 1e-15, "m");
    expect("rest offset after -0.01 m", faded(-0.01, fade, 0.01), -0.009, 1e-15, "m");
    expect("rest offset after -0.025 m, where both are the same", faded(-0.025, fade, 0.01), -0.0225, 1e-15,
           "m");
    expect("rest offset after 0", faded(0, fade, 0.01), 0.0, 0, "m");
}

TEST_CASE("faded: its arguments count")
{
    given("keep 0.5, speed 2 m/s, dt 0.1 s");
    expect("rest offset after -1 m", faded(-1, {0.5, 2}, 0.1), -0.8, 1e-15, "m");
    expect("rest offset after -0.1 m", faded(-0.1, {0.5, 2}, 0.1), -0.05, 1e-15, "m");
    given("keep 0.99, speed 2 m/s, dt 0.001 s");
    expect("rest offset after -0.3 m", faded(-0.3, {0.99, 2}, 0.001), -0.298, 1e-15, "m");
    expect("rest offset after -0.1 m", faded(-0.1, {0.99, 2}, 0.001), -0.099, 1e-15, "m");
}

TEST_CASE("steps: as many as it takes one by one")
{
    for (const Fade& fade : {Fade{}, Fade{0.5, 0.25}, Fade{0.99, 1}, Fade{0.7, 0.01}})
        for (const double dt : {0.002, 0.01, 1.0 / 60})
            for (const double depth : {0.71234567, 0.0341357, 0.0112131, 0.0031313, 0.0007171})
                for (const double left : {1e-2, 1e-3, 1e-4}) {
                    given("from ", depth, " m to less than ", left, " m, ", told(fade), ", dt ", dt, " s");
                    const int got = steps_to_fade(-depth, left, fade, dt);
                    const int right = steps_one_by_one(-depth, left, fade, dt);
                    expect("steps", got, right, 0);
                    if (got != right)
                        return;
                }
    say("half a metre: less than a millimetre to go after ", 0.01 * steps_to_fade(-0.5, 1e-3, {}, 0.01),
        " s");
}

TEST_CASE("steps: a long way has as many as it has strides")
{
    const double dt = 1.0 / 1024;  // strides without rounding
    given("from 1e6 m to 1 m, speed 1 m/s, dt 1/1024 s");
    expect("steps", steps_to_fade(-1e6, 1, {0.9, 1}, dt), (1000000 - 1) * 1024 + 1, 0);
}

TEST_CASE("work: the impulse that holds against gravity, times the speed of the ground")
{
    const ImplicitParticle particle = particle_of(3, 1e5, 0.02, PositionUpdate::end_velocity);
    given("m 3 kg, dt 0.02 s, velocity 0.25 m/s before and after, the ground rises by 5 mm");
    expect("work", work_of_rising({0, 0.25}, {0.005, 0.25}, 0.005, particle), 3 * 9.81 * 0.005, 1e-12, "J");
    given("m 3 kg, dt 0.02 s, velocity 0.25 m/s before and 1.25 m/s after, the ground rises by 5 mm");
    expect("work", work_of_rising({0, 0.25}, {0.005, 1.25}, 0.005, particle), 3 * (1 + 9.81 * 0.02) * 0.25,
           1e-12, "J");
}

TEST_CASE("work: gravity and the length of the step are the particle's")
{
    ImplicitParticle particle = particle_of(3, 1e5, 0.004, PositionUpdate::end_velocity);
    particle.gravity = 1.62;
    given("m 3 kg, g 1.62 m/s^2, dt 0.004 s, velocity 0 before and 1 m/s after, the ground rises by 2 mm");
    expect("work", work_of_rising({0, 0}, {0.002, 1}, 0.002, particle), 3 * (1 + 1.62 * 0.004) * 0.5, 1e-12,
           "J");
}

TEST_CASE("work: none on what falls freely, and none by a ground that rests")
{
    const ImplicitParticle particle = particle_of(3, 1e5, 0.02, PositionUpdate::end_velocity);
    given("m 3 kg, dt 0.02 s, velocity 1 m/s before and 1 - 9.81 * 0.02 m/s after, the ground rises by 5 mm");
    expect("work", work_of_rising({1, 1}, {1.02, 1 - 9.81 * 0.02}, 0.005, particle), 0.0, 1e-12, "J");
    given("m 3 kg, dt 0.02 s, velocity -1 m/s before and 1 m/s after, the ground rests");
    expect("work", work_of_rising({0, -1}, {0, 1}, 0, particle), 0.0, 0, "J");
}

TEST_CASE("let out: at first it lies where it began, and nothing has been done")
{
    given("0.5 m deep, no step");
    const LettingOut out = let_out(0.5, {}, {}, 0);
    expect("height", out.state.height, -0.5, 0, "m");
    expect("velocity", out.state.velocity, 0.0, 0, "m/s");
    expect("rest offset", out.rest_offset, -0.5, 0, "m");
    expect("work", out.work, 0.0, 0, "J");
}

TEST_CASE("let out: the first step is an implicit step, seen from a ground that rises")
{
    const ImplicitParticle particle = particle_of(2, 1e4, 0.01, PositionUpdate::end_velocity);
    given("0.5 m deep, m 2 kg, k 10 000 N/m, dt 0.01 s, one step");
    const LettingOut out = let_out(0.5, particle, {}, 1);
    const ParticleState seen = step({0, -0.25}, particle);
    expect("rest offset", out.rest_offset, -0.4975, 1e-15, "m");
    expect("height", out.state.height, seen.height - 0.4975, 1e-14, "m");
    expect("velocity", out.state.velocity, seen.velocity + 0.25, 1e-12, "m/s");
    expect("work", out.work, 2 * (seen.velocity + 0.25 + 0.0981) * 0.25, 1e-12, "J");
}

TEST_CASE("let out: the fade and the step are those that it is given")
{
    ImplicitParticle particle = particle_of(2, 1e4, 0.004, PositionUpdate::end_velocity);
    particle.gravity = 1.62;
    given("0.5 m deep, m 2 kg, k 10 000 N/m, g 1.62 m/s^2, dt 0.004 s, keep 0.5, speed 2 m/s, one step");
    const LettingOut out = let_out(0.5, particle, {0.5, 2}, 1);
    const ParticleState seen = step({0, -2}, particle);
    expect("rest offset", out.rest_offset, -0.492, 1e-15, "m");
    expect("height", out.state.height, seen.height - 0.492, 1e-14, "m");
    expect("velocity", out.state.velocity, seen.velocity + 2, 1e-12, "m/s");
    expect("work", out.work, 2 * (seen.velocity + 2 + 1.62 * 0.004) * 2, 1e-12, "J");
}

TEST_CASE("let out: the budget closes, on quiet and on bouncing lifts")
{
    for (const double stiffness : {1e3, 1e5, 1e7})
        for (const double mass : {0.1, 1.0, 30.0})
            for (const int steps : {10, 100, 400}) {
                const ImplicitParticle particle = particle_of(mass, stiffness, 0.01,
                                                              PositionUpdate::mean_velocity);
                given("0.5 m deep, m ", mass, " kg, k ", stiffness, " N/m, mean velocity, ", steps, " steps");
                const LettingOut out = let_out(0.5, particle, {}, steps);
                const double gained = energy_of(out, particle) + mass * particle.gravity * 0.5;
                expect("energy gained", gained, out.work, 1e-9 * (1 + std::abs(out.work)), "J");
            }
}

TEST_CASE("let out: with the end velocity nothing is thrown, and no more energy is there than was put in")
{
    for (const double stiffness : {1e4, 1e6, 1e8, 1e10})
        for (const double depth : {0.001, 0.02, 0.5}) {
            const ImplicitParticle particle = particle_of(1, stiffness, 0.01, PositionUpdate::end_velocity);
            given(depth, " m deep, m 1 kg, k ", stiffness, " N/m, end velocity, 500 steps");
            const LettingOut out = let_out(depth, particle, {}, 500);
            expect_that("it is never faster than 0.5 m/s, twice the lift", out.fastest < 0.5);
            expect_that("it was lifted at all, so it was fast at some time",
                        depth < 0.01 || out.fastest > 0.1);
            expect_that("the energy gained is not more than the work",
                        energy_of(out, particle) + particle.gravity * depth <= out.work + 1e-9);
            expect_that("it ends less than 2 mm from the surface", std::abs(out.state.height) < 2e-3);
        }
}

TEST_CASE("let out: the fastest is the largest velocity of all steps, not the last one")
{
    const ImplicitParticle particle = particle_of(1, 1e4, 0.01, PositionUpdate::end_velocity);
    double fastest = 0;
    for (int steps = 1; steps < 60; ++steps)
        fastest = std::max(fastest, let_out(0.1, particle, {}, steps).state.velocity);
    given("0.1 m deep, m 1 kg, k 10 000 N/m, end velocity, 59 steps");
    expect("fastest", let_out(0.1, particle, {}, 59).fastest, fastest, 0, "m/s");
    const LettingOut begun = let_out(0.1, particle, {}, 2);
    given("the same after two steps, while it still becomes faster");
    expect("fastest", begun.fastest, begun.state.velocity, 0, "m/s");
    given("it begins at the surface of a soft ground, k 100 N/m: three steps down");
    expect("fastest upwards",
           let_out(0, particle_of(1, 100, 0.01, PositionUpdate::end_velocity), {}, 3).fastest, 0, 0, "m/s");
}

TEST_CASE("let out: half a metre costs little more than the lifting itself")
{
    const ImplicitParticle particle = particle_of(1, 1.6e5, 0.01, PositionUpdate::end_velocity);
    given("0.5 m deep, m 1 kg, k 160 000 N/m, dt 0.01 s, end velocity, 300 steps");
    const LettingOut out = let_out(0.5, particle, {}, 300);
    const double lifting = particle.mass * particle.gravity * 0.5;
    expect_that("the work is at least that of the lifting", out.work >= 0.99 * lifting);
    say("let out to the last millimetre: ", out.work / lifting, " times m g 0.5 m of work, at most ",
        out.fastest, " m/s");
    say("you predicted ", predicted_seconds(), " s");
}
