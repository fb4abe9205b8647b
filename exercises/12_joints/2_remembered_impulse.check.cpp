#include "exercises/12_joints/2_remembered_impulse.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <cmath>

using namespace enduring;

namespace {

Held random_body(RandomInputs& random)
{
    return {std::exp(random.normal()),    random.normal(), random.normal(), 10 * random.normal(), 0.02,
            std::exp(2 * random.normal())};
}

const Held hanging{2, 0, 0, -20, 0.1, 10};

}  // namespace

TEST_CASE("place: load and impulse change the velocity, and the new velocity the place")
{
    given("2 kg at 3 m with 5 m/s, a load of -20 N, dt 0.1 s");
    Held body = hanging;
    body.place = 3;
    body.velocity = 5;
    expect("without impulse", place_after(body, 0), 3.4, 1e-13, "m");
    expect("with the impulse of the load", place_after(body, 2), 3.5, 1e-13, "m");
}

TEST_CASE("round: the new impulse is the last one less what the spring answers to the new error")
{
    RandomInputs random(2);
    for (int run = 0; run < 100; ++run) {
        const Held body = random_body(random);
        const double p = random.normal(), next = next_impulse(body, p),
                     k = body.h * body.mass / (body.dt * body.dt);
        const double place = body.place +
                             body.dt * (body.velocity + (body.load * body.dt + next) / body.mass);
        given("run ", run);
        expect("p_new + k dt r - p", next + k * body.dt * place - p, 0,
               1e-10 * (1 + std::abs(p) + k * body.dt * (std::abs(body.place) + 1)), "N s");
    }
}

TEST_CASE("round: the impulse that holds is left as it is, however soft the spring")
{
    for (const double h : {0.1, 10.0, 1e4}) {
        Held body = hanging;
        body.h = h;
        given("a load of -20 N for 0.1 s, h = ", h);
        expect("the impulse of the load", next_impulse(body, 2), 2, 1e-12, "N s");
    }
}

TEST_CASE("errors: each round leaves the same part, whatever body and load")
{
    RandomInputs random(3);
    for (int run = 0; run < 50; ++run) {
        const Held body = random_body(random);
        const std::vector<double> left = errors(body, random.normal(), 4);
        given("run ", run, ", h = ", body.h);
        expect_that("one number a round", left.size() == 4);
        for (std::size_t i = 1; i < left.size() && left.size() == 4; ++i)
            expect("error times (1 + h), over the one before", left[i] * (1 + body.h) / left[i - 1], 1, 1e-6,
                   "");
    }
    const std::vector<double> first = errors(hanging, 0, 1);
    given("a load of -20 N on 2 kg for 0.1 s, h = 10, without an impulse before");
    expect_that("one number for one round", first.size() == 1);
    if (first.size() == 1)
        expect("error after the first round", first[0], -0.1 / 11, 1e-12, "m");
    const std::vector<double> right = errors(hanging, 2, 1);
    given("the same, which begins with the impulse of the load");
    if (right.size() == 1)
        expect("error after the first round", right[0], 0, 1e-13, "m");
}

TEST_CASE("rounds: as many as the tolerance takes, and none where nothing is wrong")
{
    given("a body at rest without a load");
    expect("rounds", rounds_needed({2, 0, 0, 0, 0.1, 10}, 1e-9), 0, 0, "");
    int needed[3];
    for (int i = 0; i < 3; ++i) {
        Held body = hanging;
        body.h = i == 0 ? 1 : i == 1 ? 100 : 1e7;
        const double tolerance = 1e-9;
        needed[i] = rounds_needed(body, tolerance);
        given("h = ", body.h);
        double left = 0.1;
        int rounds = 0;
        for (; left > tolerance; ++rounds)
            left /= 1 + body.h;
        expect("rounds", needed[i], rounds, 0, "");
    }
    say("h = 1 takes ", needed[0], " rounds to a billionth of a metre, h = 100 takes ", needed[1],
        ", h = 10^7 takes ", needed[2]);
}
