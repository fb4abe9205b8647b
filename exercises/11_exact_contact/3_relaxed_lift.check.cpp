#include "exercises/11_exact_contact/3_relaxed_lift.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <cmath>

using namespace enduring;

TEST_CASE("impulse: a block that holds is stopped, and one that flies is left alone")
{
    given("free velocity (-1, 0.3, 0.4) m/s, 2 kg, mu 0.6");
    expect("impulse", relaxed_impulse(Vec3(-1, 0.3, 0.4), 2, 0.6), Vec3(2, -0.6, -0.8), 1e-13, "N s");
    given("free velocity (3, 1, 0) m/s, 2 kg, mu 0.5");
    expect("impulse", relaxed_impulse(Vec3(3, 1, 0), 2, 0.5), Vec3(0, 0, 0), 1e-13, "N s");
    given("free velocity (0.6, 1, 0) m/s, 2 kg, mu 0.5");
    expect("impulse", relaxed_impulse(Vec3(0.6, 1, 0), 2, 0.5), Vec3(0, 0, 0), 1e-13, "N s");
}

TEST_CASE("impulse: a block that slides is pushed up, though it does not come in")
{
    given("free velocity (0, 3, 4) m/s, 2 kg, mu 0.5");
    expect("impulse", relaxed_impulse(Vec3(0, 3, 4), 2, 0.5), Vec3(4, -1.2, -1.6), 1e-13, "N s");
    given("free velocity (0.4, 1, 0) m/s, 2 kg, mu 0.5");
    expect("impulse", relaxed_impulse(Vec3(0.4, 1, 0), 2, 0.5), Vec3(0.16, -0.08, 0), 1e-13, "N s");
}

TEST_CASE("impulse: no other one of the cone leaves less energy")
{
    RandomInputs random(3);
    for (int i = 0; i < 300; ++i) {
        const Vec3 q = random.normal_vector();
        const double mass = std::exp(random.normal()), mu = 0.1 + std::abs(random.normal());
        given("free velocity ", q.transpose(), " m/s, mass ", mass, " kg, mu ", mu);
        const Vec3 impulse = relaxed_impulse(q, mass, mu);
        expect_that("it lies in the cone", std::hypot(impulse.y(), impulse.z()) <= mu * impulse.x() + 1e-12);
        for (int other = 0; other < 20; ++other) {
            Vec3 near = impulse + 0.1 * mass * random.normal_vector();
            near.x() = std::max(near.x(), std::hypot(near.y(), near.z()) / mu);
            expect_that("another one of the cone leaves more energy",
                        (q + near / mass).squaredNorm() >= (q + impulse / mass).squaredNorm() - 1e-12);
        }
    }
}

TEST_CASE("rising: what slides is thrown up with mu times its slip")
{
    given("free velocity (0, 3, 4) m/s, 2 kg, mu 0.5");
    expect("rising speed", rising_speed(Vec3(0, 3, 4), 2, 0.5), 2, 1e-13, "m/s");
    given("free velocity (-1, 3, 4) m/s, 2 kg, mu 0.5");
    expect("rising speed", rising_speed(Vec3(-1, 3, 4), 2, 0.5), 1.8, 1e-13, "m/s");
    given("free velocity (-1, 0.3, 0.4) m/s, 2 kg, mu 0.6");
    expect("rising speed", rising_speed(Vec3(-1, 0.3, 0.4), 2, 0.6), 0, 1e-13, "m/s");
    given("free velocity (3, 1, 0) m/s, 2 kg, mu 0.5");
    expect("rising speed", rising_speed(Vec3(3, 1, 0), 2, 0.5), 3, 1e-13, "m/s");
}

TEST_CASE("gap: a far block falls, one at rest stays, and one that slides on the ground leaves it")
{
    given("gap 1 m, at rest, mu 0.5, dt 0.01 s");
    expect("gap after", gap_after({1, 0, 0}, 0.5, 0.01), 1 - 9.81e-4, 1e-12, "m");
    given("on the ground, at rest, mu 0.5, dt 0.01 s");
    expect("gap after", gap_after({0, 0, 0}, 0.5, 0.01), 0, 1e-12, "m");
    given("on the ground, 1 m/s, mu 0.5, dt 0.01 s");
    expect("gap after", gap_after({0, 0, 1}, 0.5, 0.01), 0.005 * (1 - 0.5 * 0.0981) / 1.25, 1e-12, "m");
    given("gap 0.01 m, falls with 2 m/s, slides with 1 m/s, mu 0.5, dt 0.01 s");
    expect("gap after", gap_after({0.01, -2, 1}, 0.5, 0.01), 0.005 * (1 - 0.5 * 1.0981) / 1.25, 1e-12, "m");
}

TEST_CASE("floating: where the contact pushes, the gap after a step is that of the speed after it")
{
    given("1 m/s, mu 0.5, dt 0.01 s");
    expect("floating gap", floating_gap(1, 0.5, 0.01), 0.005, 1e-14, "m");
    for (const double mu : {0.2, 0.5, 1.0})
        for (const double speed : {1.0, 3.0})
            for (const double dt : {0.001, 0.01}) {
                given("mu ", mu, ", ", speed, " m/s, dt ", dt, " s");
                const double gap = floating_gap(speed, mu, dt);
                const Vec3 free_velocity(gap / dt - 9.81 * dt, speed, 0);
                const Vec3 after = free_velocity + relaxed_impulse(free_velocity, 1, mu);
                expect("gap after a step from there", gap_after({gap, 0, speed}, mu, dt),
                       floating_gap(after.y(), mu, dt), 1e-12, "m");
            }
    say("mu 0.5, 3 m/s: floats at ", 1e3 * floating_gap(3, 0.5, 0.01), " mm with steps of 10 ms, at ",
        1e3 * floating_gap(3, 0.5, 0.001), " mm with steps of 1 ms");
}
