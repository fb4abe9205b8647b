#include "exercises/08_speculative_contacts/1_margin.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

using namespace enduring;

namespace {

const char* told(Found found)
{
    switch (found) {
        case Found::near_start: return "near at the start";
        case Found::crossing: return "crossing";
        default: return "not at all";
    }
}

void expect_found(const Approach& approach, double dt, double margin, Found expected)
{
    const Found got = find_pair(approach, 9.81, dt, margin);
    given("gap ", approach.gap, " m, speed ", approach.speed, " m/s, dt ", dt, " s, margin ", margin, " m");
    expect_that(in_words("the pair is found: ", told(expected), "; got: ", told(got)), got == expected);
}

}  // namespace

TEST_CASE("prediction: a number is written down")
{
    expect_that("the prediction is positive",
                predicted_millimetres() > 0 && std::isfinite(predicted_millimetres()));
}

TEST_CASE("fall: a step from rest is g dt^2, not half of it")
{
    for (const double gravity : {9.81, 1.62})
        for (const double dt : {0.01, 0.002}) {
            given("g ", gravity, " m/s^2, dt ", dt, " s");
            expect("fall in one step", fall_from_rest(gravity, dt, 1), gravity * dt * dt, 1e-15, "m");
            expect("fall in no step", fall_from_rest(gravity, dt, 0), 0, 1e-15, "m");
        }
    say("from rest, in a step of 0.01 s: ", 1000 * fall_from_rest(9.81, 0.01, 1), " mm");
}

TEST_CASE("fall: many steps are what the scheme sums up")
{
    double height = 0, velocity = 0;
    for (int step = 1; step <= 200; ++step) {
        velocity += 9.81 * 0.01;
        height += 0.01 * velocity;
        given("g 9.81 m/s^2, dt 0.01 s, steps ", step);
        expect("fall", fall_from_rest(9.81, 0.01, step), height, 1e-9, "m");
    }
    given("g 10 m/s^2, dt 0.001 s, steps 100 000");
    expect("fall", fall_from_rest(10, 0.001, 100000), 10 * 0.001 * 0.001 * 5000050000.0, 1e-3, "m");
}

TEST_CASE("margin: gravity decides it, and where that is weak the smallest body")
{
    given("g 9.81 m/s^2, dt 0.01 s, smallest body 1 m, fall 1.5, nearness 1e-4");
    expect("margin", margin_of(9.81, 0.01, 1, 1.5, 1e-4), 1.4715e-3, 1e-12, "m");
    given("the same without gravity, and with a body of 20 m");
    expect("margin", margin_of(0, 0.01, 20, 1.5, 1e-4), 2e-3, 1e-12, "m");
    given("g 9.81 m/s^2, dt 0.01 s, smallest body 1 m, fall 3, nearness 1e-4");
    expect("margin", margin_of(9.81, 0.01, 1, 3, 1e-4), 2.943e-3, 1e-12, "m");
    given("dt 0.001 s, smallest body 1 m, fall 3, nearness 1e-3");
    expect("margin", margin_of(9.81, 0.001, 1, 3, 1e-3), 1e-3, 1e-12, "m");
}

TEST_CASE("step: the velocity first, and then the position with it")
{
    const Approach after = after_a_step({1, 2}, 9.81, 0.1);
    given("gap 1 m, speed 2 m/s, g 9.81 m/s^2, dt 0.1 s");
    expect("speed", after.speed, 2.981, 1e-12, "m/s");
    expect("gap", after.gap, 0.7019, 1e-12, "m");
}

TEST_CASE("find: near at the start comes first, then a crossing, and what ends outside needs no pair yet")
{
    const double dt = 0.01, margin = 1.5e-3;
    expect_found({1e-3, 0}, dt, margin, Found::near_start);
    expect_found({1e-3, -5}, dt, margin, Found::near_start);
    expect_found({1e-3, 100}, dt, margin, Found::near_start);
    expect_found({-1e-3, 0}, dt, margin, Found::near_start);
    expect_found({-0.5, 0}, dt, margin, Found::near_start);
    expect_found({1.5e-3, 0}, dt, margin, Found::near_start);
    expect_found({0.5, 100}, dt, margin, Found::crossing);
    expect_found({1.5001e-3, 0.06}, dt, margin, Found::crossing);
    expect_found({0.8e-3, 0}, dt, 0.5e-3, Found::crossing);
    expect_found({0.5, 49.8}, dt, margin, Found::not_at_all);
    expect_found({2e-3, 0}, dt, margin, Found::not_at_all);
    expect_found({0.5, 49.7}, dt, margin, Found::not_at_all);
    expect_found({2e-3, -1}, dt, margin, Found::not_at_all);
    expect_found({3e-3, 0}, dt, margin, Found::not_at_all);
}

TEST_CASE("find: with both questions, whatever falls has its pair before it is inside")
{
    RandomInputs random(1);
    for (int trial = 0; trial < 500; ++trial) {
        Approach approach{random.number(0.01, 3.01), random.number(-5, 25)};
        const double dt = random.number(0.002, 0.022), margin = margin_of(9.81, dt, 1, 1.5, 1e-4);
        given("gap ", approach.gap, " m, speed ", approach.speed, " m/s, dt ", dt, " s");
        for (int step = 0; step < 10000; ++step) {
            if (find_pair(approach, 9.81, dt, margin) != Found::not_at_all)
                break;
            approach = after_a_step(approach, 9.81, dt);
            if (approach.gap < 0) {
                expect_that("it is found before it is inside", false);
                return;
            }
        }
        if (approach.gap < 0)
            return;
    }
}

TEST_CASE("first question only: who rests within the margin is found outside, who comes fast is not")
{
    const double dt = 0.01, margin = 1.5e-3;
    given("gap 1 mm, speed 0, dt 0.01 s, margin 1.5 mm");
    expect("depth", depth_when_found({1e-3, 0}, 9.81, dt, margin), 0, 1e-12, "m");
    given("gap 1.5 mm, just on the margin, speed 10 m/s, dt 0.01 s, margin 1.5 mm");
    expect("depth", depth_when_found({1.5e-3, 10}, 9.81, dt, margin), 0, 1e-12, "m");
    given("gap 2 mm, speed 0, dt 0.01 s, margin 1.5 mm");
    expect("depth", depth_when_found({2e-3, 0}, 9.81, dt, margin), 0, 1e-12, "m");
    given("gap 0.5 m, speed 80 m/s, dt 0.01 s, margin 1.5 mm");
    expect("depth", depth_when_found({0.5, 80}, 9.81, dt, margin), 0.300981, 1e-9, "m");
    double deepest = 0;
    for (double gap = 0.05; gap < 0.07; gap += 1e-5)
        deepest = std::max(deepest, depth_when_found({gap, 0}, 9.81, dt, margin));
    double expected = 0;
    for (double gap = 0.05; gap < 0.07; gap += 1e-5) {
        double height = gap, velocity = 0;
        while (height > margin) {
            velocity += 9.81 * dt;
            height -= velocity * dt;
        }
        expected = std::max(expected, -height);
    }
    given("gaps of 50 mm to 70 mm, at rest");
    expect("deepest of all", deepest, expected, 1e-9, "m");
    say("dropped from 5 cm to 7 cm, found at the start only: up to ", 1000 * deepest, " mm deep");
    say("you predicted ", predicted_millimetres(), " mm");
}
