#include "exercises/04_friction/4_hung_on_a_spring.hpp"
#include "exercises/checking.hpp"

#include <cmath>

namespace enduring {

TEST_CASE("prediction: a number is written down")
{
    expect_that("the predicted ratio is at least 1",
                predicted_ratio() >= 1 && std::isfinite(predicted_ratio()));
    say("zeta 0: ", std::round(100 * smallest_ratio(0)) / 100, " times the tangent, the law says ",
        overshoot_law(0));
}

TEST_CASE(
    "measurement: without a damper a little more than twice the tangent holds, and a little less does not")
{
    given("1 kg on a spring of 1000 N/m, no damper");
    expect_that("2.02 times the tangent holds", holds_the_block(2.02, 0));
    expect_that("1.98 times the tangent does not", !holds_the_block(1.98, 0));
}

TEST_CASE("measurement: the tangent itself holds with a critical damper only, and what is less never")
{
    given("1 kg on a spring of 1000 N/m");
    expect_that("0.99 times the tangent does not hold with the critical damper", !holds_the_block(0.99, 1));
    expect_that("1.2 times the tangent holds with the critical damper", holds_the_block(1.2, 1));
    expect_that("1.2 times the tangent does not hold with a tenth of it", !holds_the_block(1.2, 0.1));
}

TEST_CASE("measurement: a tenth of the tangent does not hold, whatever the damper")
{
    for (const double damping : {0.0, 1.0, 10.0}) {
        given("1 kg on a spring of 1000 N/m, zeta ", damping);
        expect_that("a ratio of 0.1 does not hold", !holds_the_block(0.1, damping));
    }
}

TEST_CASE("measurement: the smallest ratio holds, and a little less does not, to a thousandth")
{
    for (const double damping : {0.0, 0.1, 0.35, 0.8}) {
        const double smallest = smallest_ratio(damping);
        given("1 kg on a spring of 1000 N/m, zeta ", damping, ", your smallest ratio is ",
              readable(smallest));
        expect_that("0.001 more than it holds", holds_the_block(smallest + 0.001, damping));
        expect_that("0.001 less than it does not", !holds_the_block(smallest - 0.001, damping));
    }
}

TEST_CASE("law: it is 2 without a damper and falls as the damper grows")
{
    expect("at zeta 0", overshoot_law(0), 2.0, 1e-15);
    // acos(0.6) = 0.927295, sqrt(1 - 0.36) = 0.8.
    expect("at zeta 0.6", overshoot_law(0.6), 1 + std::exp(-1.5 * 0.9272952180016122), 1e-12);
}

TEST_CASE("law: the measured ratio is the law's")
{
    for (const double damping : {0.2, 0.5}) {
        given("zeta ", damping);
        const double measured = smallest_ratio(damping), law = overshoot_law(damping);
        expect_that("law and measurement agree to 0.002; your law says " + readable(law) +
                        ", your measurement " + readable(measured),
                    std::abs(measured - law) <= 0.002);
        say("zeta ", damping, ": ", std::round(100 * measured) / 100, " times the tangent, the law says ",
            law);
    }
    say("you predicted ", predicted_ratio());
}

}  // namespace enduring
