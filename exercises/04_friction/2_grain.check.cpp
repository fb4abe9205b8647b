#include "exercises/04_friction/2_grain.hpp"
#include "exercises/checking.hpp"

#include <cmath>
#include <numbers>

namespace enduring {
namespace {

const Grain brushed{{1, 0}, 0.2, 0.5};
const Grain turned{{0.6, 0.8}, 0.2, 0.5};

/// The impulse that takes the most energy among many on the ellipse's edge.
Vec2 most_dissipating(const Grain& grain, const Vec2& velocity, double normal_impulse)
{
    Vec2 best = Vec2::Zero();
    const Vec2 across(-grain.direction.y(), grain.direction.x());
    for (int i = 0; i < 20000; ++i) {
        const double angle = i * std::numbers::pi / 10000;
        const Vec2 impulse = normal_impulse * (grain.mu_along * std::cos(angle) * grain.direction +
                                               grain.mu_across * std::sin(angle) * across);
        if (impulse.dot(velocity) < best.dot(velocity))
            best = impulse;
    }
    return best;
}

}  // namespace

TEST_CASE("ellipse: it holds mu_along along the grain, mu_across across it, and less than a box in between")
{
    given("grain along (0.6, 0.8), mu 0.2 along and 0.5 across, normal impulse 10 N s");
    expect_that("1.99 N s along the grain is held", holds(turned, Vec2(0.6, 0.8) * 1.99, 10));
    expect_that("2.01 N s along the grain is not", !holds(turned, Vec2(0.6, 0.8) * 2.01, 10));
    expect_that("4.99 N s across the grain is held", holds(turned, Vec2(0.8, -0.6) * 4.99, 10));
    expect_that("5.01 N s across the grain is not", !holds(turned, Vec2(0.8, -0.6) * 5.01, 10));
    expect_that("1.5 N s along and 4 N s across together are not",
                !holds(turned, Vec2(0.6, 0.8) * 1.5 + Vec2(-0.8, 0.6) * 4, 10));
    expect_that("1.3 N s along and 3.6 N s across together are",
                holds(turned, Vec2(0.6, 0.8) * 1.3 + Vec2(-0.8, 0.6) * 3.6, 10));
}

TEST_CASE("ellipse: its very edge is held, on both axes")
{
    const Grain even{{1, 0}, 0.5, 0.25};  // powers of two: every number on the way is exact
    given("grain along (1, 0), mu 0.5 along and 0.25 across, normal impulse 8 N s");
    expect("-4.1 N s along the grain is held (0 no, 1 yes)", holds(even, Vec2(-4.1, 0), 8) ? 1 : 0, 0, 0);
    expect("-4 N s along the grain is held (0 no, 1 yes)", holds(even, Vec2(-4, 0), 8) ? 1 : 0, 1, 0);
    expect("2 N s across the grain is held (0 no, 1 yes)", holds(even, Vec2(0, 2), 8) ? 1 : 0, 1, 0);
}

TEST_CASE("slip: along and across the grain friction is straight against it")
{
    given("grain along (0.6, 0.8), mu 0.2 along and 0.5 across, normal impulse 10 N s");
    expect("along the grain", sliding_impulse(turned, Vec2(0.6, 0.8) * 3, 10), Vec2(-1.2, -1.6), 1e-6, "N s");
    expect("across the grain", sliding_impulse(turned, Vec2(0.8, -0.6) * 3, 10), Vec2(-4, 3), 1e-6, "N s");
    expect("without slip", sliding_impulse(turned, Vec2(0, 0), 10), Vec2(0, 0), 0, "N s");
}

TEST_CASE("slip: no impulse on the ellipse takes more energy")
{
    for (const Vec2& velocity : {Vec2(1, 1), Vec2(-2, 0.3), Vec2(0.1, -4)}) {
        given("slip ", readable(velocity),
              " m/s, grain along (0.6, 0.8), mu 0.2 along and 0.5 across, normal impulse 10 N s");
        const Vec2 best = most_dissipating(turned, velocity, 10);
        expect("friction impulse", sliding_impulse(turned, velocity, 10), best, 2e-3, "N s");
    }
}

TEST_CASE("slip: without a grain it is Coulomb's law")
{
    const Grain none{{0.6, 0.8}, 0.4, 0.4};
    given("slip (3, -4) m/s, mu 0.4 in all directions, normal impulse 10 N s");
    expect("friction impulse", sliding_impulse(none, {3, -4}, 10), Vec2(-2.4, 3.2), 1e-6, "N s");
}

TEST_CASE("floor: along and across the grain a block stops after v^2 / (2 mu g)")
{
    given("2 m/s, mu 0.2 along and 0.5 across, g 9.81 m/s^2, dt 0.1 ms");
    const Vec2 along = stopping_place(brushed, {2, 0}, 9.81, 1e-4),
               across = stopping_place(brushed, {0, 2}, 9.81, 1e-4);
    expect("place, launched along the grain", along, Vec2(4 / (0.4 * 9.81), 0), 5e-4, "m");
    expect("place, launched across it", across, Vec2(0, 4 / 9.81), 5e-4, "m");
    say("launched at 2 m/s, g 9.81 m/s^2: along the grain it stops after ", along.norm(), " m, across after ",
        across.norm(), " m");
}

TEST_CASE("floor: in each step the block moves by the new velocity")
{
    given(
        "2 m/s along the grain, mu 0.2 along it, g 9.81 m/s^2, dt 0.1 s: it slows down by 0.1962 m/s a step, and moves in ten of them");
    const double ten_steps = 0.1 * (10 * 2 - 55 * 0.1962);
    expect("place", stopping_place(brushed, {2, 0}, 9.81, 0.1), Vec2(ten_steps, 0), 1e-6, "m");
}

TEST_CASE("floor: a block that friction would throw back stays where it is")
{
    const Grain even{{1, 0}, 0.75, 0.75};
    given("0.5 m/s along the grain, mu 0.75, g 10 m/s^2, dt 0.1 s: friction takes 0.75 m/s a step");
    expect("place", stopping_place(even, {0.5, 0}, 10, 0.1), Vec2(0, 0), 1e-9, "m");
}

TEST_CASE("floor: a block whose motion turns by less than a right angle goes on")
{
    // Along and across, v = (1.2, 0.8) loses (0.6, 1.6): (0.6, -0.8) points forward. What comes next would
    // not.
    const Grain grain{{1, 0}, 0.5, 1};
    for (const double sign : {1.0, -1.0}) {
        const Vec2 velocity = sign * Vec2(1.2, 0.8);
        given(readable(velocity),
              " m/s, grain along (1, 0), mu 0.5 along and 1 across, g 10 m/s^2, dt 0.2 s");
        expect("place", stopping_place(grain, velocity, 10, 0.2), Vec2(sign * 0.2 * Vec2(0.6, -0.8)), 1e-6,
               "m");
    }
}

TEST_CASE("floor: slow or fast, ten and a half steps' worth of speed carry it 50 mu g dt^2")
{
    for (const double dt : {1e-4, 1e-2, 1.0, 10.0})
        for (const double sign : {1.0, -1.0}) {
            const double loss = 0.2 * 10 * dt;  // of speed in a step
            given(sign * 10.5 * loss, " m/s along the grain, mu 0.2 along it, g 10 m/s^2, dt ", dt, " s");
            expect("place", stopping_place(brushed, {sign * 10.5 * loss, 0}, 10, dt),
                   Vec2(sign * 50 * loss * dt, 0), 1e-4 * loss * dt, "m");
        }
}

TEST_CASE("floor: launched at an angle the block turns towards the grain")
{
    given("2 m/s at 45 degrees to the grain, mu 0.2 along and 0.5 across, g 9.81 m/s^2, dt 0.1 ms");
    const Vec2 place = stopping_place(brushed, Vec2(1, 1) * std::sqrt(2.0), 9.81, 1e-4);
    expect_that("it gets further along the grain than across", place.x() > 1.3 * place.y());
    expect("place with half the step", stopping_place(brushed, Vec2(1, 1) * std::sqrt(2.0), 9.81, 5e-5),
           place, 5e-4, "m");
    say("at 45 degrees it stops at ", readable(Vec2((place * 1000).array().round() / 1000)),
        " m: the grain turns it");
}

}  // namespace enduring
