#include "exercises/06_redefinition/4_changes_of_face.hpp"
#include "exercises/checking.hpp"

#include <cmath>

namespace enduring {
namespace {

constexpr double dt = 0.01;

/// Changes over a way of some cells along x and z, at 5 m/s.
int changes(double cells_x, double cells_z)
{
    const double length = std::hypot(cells_x, cells_z);
    World world = sliding_tip(5 * cells_x / length, 5 * cells_z / length);
    return measured_changes(world, static_cast<int>(std::lround(length / 5 / dt)), dt);
}

}  // namespace

TEST_CASE("prediction: a number is written down")
{
    expect_that("the prediction is not negative",
                predicted_changes() >= 0 && std::isfinite(predicted_changes()));
}

TEST_CASE("measurement: along x the face changes twice in every cell")
{
    given("8 cells along x, 0.05 cells a step");
    expect("changes", changes(8, 0), 16, 1);
}

TEST_CASE("measurement: who does not move changes nothing")
{
    World world = sliding_tip(0, 0);
    given("20 steps of a tip at rest");
    expect("changes", measured_changes(world, 20, dt), 0, 0);
}

TEST_CASE("law: straight along x and z two borders a cell, along the diagonal two, across it four")
{
    expect("5 cells along x", law_of_changes(5, 0), 10.0, 1e-12);
    expect("5 cells against z", law_of_changes(0, -5), 10.0, 1e-12);
    expect("5 cells along the diagonals", law_of_changes(5, 5), 10.0, 1e-12);
    expect("5 cells across the diagonals", law_of_changes(5, -5), 20.0, 1e-12);
}

TEST_CASE("law: measured and law agree, but for borders that are crossed in one and the same step")
{
    for (const auto& [x, z] : {std::pair(10.0, 3.0), std::pair(7.0, 7.0), std::pair(6.0, -6.0)}) {
        given(x, " cells along x and ", z, " along z");
        const int measured = changes(x, z);
        const double law = law_of_changes(x, z);
        expect_that("your law says " + readable(law) + ", your measurement " + readable(measured) +
                        ", and they differ by 2 at most",
                    std::abs(measured - law) <= 2);
        say(x, " cells along x and ", z, " along z: ", measured, " changes, the law says ", law);
    }
    say("you predicted ", predicted_changes());
}

}  // namespace enduring
