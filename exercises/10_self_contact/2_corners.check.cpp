#include "exercises/10_self_contact/2_corners.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <numbers>

using namespace enduring;

namespace {

constexpr double pi = std::numbers::pi;

/// Whether friction holds a corner that is pulled by 1 N on one side and by `pull` [N] on the other: the
/// post's push is in its cone.
bool holds(double mu, double turn, double pull)
{
    const Vec3 held(-1, 0, 0),
        pulled(std::cos(turn), -std::sin(turn), 0);  // the rope comes from the left and turns down
    const Vec3 push = -(held + pull * pulled);
    const Vec3 outwards = -(held + pulled).normalized();  // the bisector, out of the post
    const double normal = push.dot(outwards);
    return normal >= 0 && (push - normal * outwards).norm() <= mu * normal;
}

/// The largest pull that is held, by halving; infinity above a million newtons.
double largest_held(double mu, double turn)
{
    double low = 1, high = 1e6;
    if (holds(mu, turn, high))
        return INFINITY;
    for (int i = 0; i < 100; ++i) {
        const double middle = std::sqrt(low * high);
        (holds(mu, turn, middle) ? low : high) = middle;
    }
    return low;
}

}  // namespace

TEST_CASE("prediction: a number is written down")
{
    expect_that("the prediction is positive", predicted_turns() > 0 && std::isfinite(predicted_turns()));
}

TEST_CASE("corner: the limit is where the forces of the post leave the cone of friction")
{
    RandomInputs random(102);
    for (int trial = 0; trial < 200; ++trial) {
        const double mu = random.number(0.01, 0.9), turn = random.number(0.05, 1.4);
        given("mu ", mu, ", turn ", turn, " rad");
        const double expected = largest_held(mu, turn);
        expect("ratio", corner_factor(mu, turn), expected, 1e-9 * expected, "");
    }
}

TEST_CASE("corner: without friction, or without a turn, nothing is held")
{
    for (const double turn : {0.0, 0.3, 2.0}) {
        given("mu 0, turn ", turn, " rad");
        expect("ratio", corner_factor(0, turn), 1, 1e-12, "");
    }
    given("mu 0.5, turn 0");
    expect("ratio", corner_factor(0.5, 0), 1, 1e-12, "");
}

TEST_CASE("corner: from some turn on every pull is held")
{
    for (const double mu : {0.5, 1.0, 2.0})
        for (const double beyond : {1.01, 1.2}) {
            const double turn = std::min(3.1, beyond * 2 * std::atan(1 / mu));
            given("mu ", mu, ", turn ", turn, " rad");
            expect_that("the ratio is infinity",
                        std::isinf(corner_factor(mu, turn)) && corner_factor(mu, turn) > 0);
        }
}

TEST_CASE("post: what corners hold is the product of what each of them holds")
{
    for (const int corners : {1, 2, 4, 7}) {
        const double turn = 2.0 / corners;
        double expected = 1;
        for (int i = 0; i < corners; ++i)
            expected *= largest_held(0.3, turn);
        given("mu 0.3, angle 2 rad, corners ", corners);
        expect("ratio", post_factor(0.3, 2, corners), expected, 1e-8 * expected, "");
    }
    say("a square post and one turn, mu 0.2: ", post_factor(0.2, 2 * pi, 4), ", a round one ",
        capstan_factor(0.2, 2 * pi));
    say("you predicted ", predicted_turns(), " turns");
}

TEST_CASE("round: many corners hold what the sum of small pieces does")
{
    for (const double mu : {0.02, 0.2, 0.5}) {
        double pull = 1;  // along the turn it grows by mu times itself
        for (int i = 0; i < 200000; ++i)
            pull *= (1 + mu * 2 * pi / 400000) / (1 - mu * 2 * pi / 400000);
        given("mu ", mu, ", one turn");
        expect("ratio", capstan_factor(mu, 2 * pi), pull, 1e-7 * pull, "");
        expect("ratio with 10000 corners", post_factor(mu, 2 * pi, 10000), pull, 1e-5 * pull, "");
    }
}

TEST_CASE("turns: one more turn multiplies the ratio again")
{
    for (const double mu : {0.1, 0.2, 0.5})
        for (const double turns : {0.0, 0.25, 1.0, 3.5}) {
            const double ratio = std::pow(post_factor(mu, 2 * pi, 100000), turns);
            given("mu ", mu, ", ratio ", ratio);
            expect("turns", turns_for(mu, ratio), turns, 1e-6, "");
        }
}

TEST_CASE("needed: so many corners are enough, and one less is not")
{
    for (const double mu : {0.1, 0.3})
        for (const double error : {0.3, 0.01, 1e-4}) {
            const int corners = corners_needed(mu, 2 * pi, error);
            given("mu ", mu, ", one turn, error ", error, ", corners ", corners);
            const auto held = [&](int some) {
                return some < 1 ? INFINITY : std::pow(largest_held(mu, 2 * pi / some), some);
            };
            const double round = std::exp(mu * 2 * pi);
            expect_that("so many corners are enough",
                        corners > 0 && held(corners) <= (1 + error + 1e-9) * round);
            expect_that("one less is not", !(held(corners - 1) <= (1 + error - 1e-9) * round));
        }
}
