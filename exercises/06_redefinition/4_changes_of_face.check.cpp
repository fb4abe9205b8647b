#include "exercises/06_redefinition/4_changes_of_face.hpp"
#include "common/simulation/point_masses.hpp"
#include "exercises/checking.hpp"

#include <cmath>

namespace enduring {
namespace {

constexpr double dt = 0.01;

/// Changes over a way of some cells along x and z, at 5 m/s.
int changes(double cells_x, double cells_z, double step = dt)
{
    const double length = std::hypot(cells_x, cells_z);
    World world = sliding_tip(5 * cells_x / length, 5 * cells_z / length);
    return measured_changes(world, static_cast<int>(std::lround(length / 5 / step)), step);
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

TEST_CASE("measurement: steps of any length see the same changes, as long as they see each cell")
{
    for (const double step : {0.005, 0.02}) {
        given("8 cells along x at 5 m/s, steps of ", step, " s");
        expect("changes", changes(8, 0, step), 16, 1);
    }
}

TEST_CASE("measurement: who does not move changes nothing")
{
    World world = sliding_tip(0, 0);
    given("20 steps of a tip at rest");
    expect("changes", measured_changes(world, 20, dt), 0, 0);
}

TEST_CASE("measurement: only the tip's own pair counts, whoever else slides")
{
    {
        given("20 steps of a tip at rest (body 1), and another that slides (body 2)");
        World two = sliding_tip(0, 0), other = sliding_tip(-5, -5);
        two.bodies.push_back(std::move(other.bodies[1]));
        expect("changes", measured_changes(two, 20, dt), 0, 0);
    }
    {
        given("20 steps of a body with two tips: that of vertex 0 rests, that of vertex 4 slides");
        World twins = sliding_tip(0, 0);
        const auto first = twins.bodies[1]->positions_t0();
        std::vector<Vec3> points(first.begin(), first.end());
        for (int i = 0; i < 4; ++i)
            points.push_back(points[static_cast<std::size_t>(i)] + Vec3(9, 0, 0.4));
        auto both = std::make_unique<PointMasses>(
            "tips", points,
            std::vector<Face>{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {4, 5, 6}, {4, 6, 7}, {4, 7, 5}}, 1,
            Vec3(0, -1e-4, 0));
        for (int i = 4; i < 8; ++i)
            both->set_velocity(i, Vec3(5, -1e-4, 0));
        twins.bodies[1] = std::move(both);
        expect("changes", measured_changes(twins, 20, dt), 0, 0);
    }
}

TEST_CASE("measurement: who comes back changes back, and a face that was there before counts again")
{
    World thrown = sliding_tip(10, 0);
    thrown.gravity = Vec3(-10, 0, 0);
    given("a tip that slides 5 cells along x, slows down and comes back, in 2 s");
    expect("changes", measured_changes(thrown, 200, dt), 20, 2);
}

TEST_CASE("measurement: who leaves the floor changes nothing any more")
{
    World lifted = sliding_tip(0, 0);
    lifted.gravity = Vec3(0, 0.002, 0);
    given("a tip that sinks in and is lifted out again, and does not slide");
    expect("changes", measured_changes(lifted, 40, dt), 0, 0);
}

TEST_CASE("law: straight along x and z two borders a cell, along the diagonal two, across it four")
{
    expect("5 cells along x", law_of_changes(5, 0), 10.0, 1e-12);
    expect("5 cells against z", law_of_changes(0, -5), 10.0, 1e-12);
    expect("5 cells along the diagonals", law_of_changes(5, 5), 10.0, 1e-12);
    expect("5 cells across the diagonals", law_of_changes(5, -5), 20.0, 1e-12);
}

TEST_CASE("law: twice the longer side along the diagonals, twice both sides across them, in every direction")
{
    for (const double longer : {7.0, 11.0})
        for (const double shorter : {0.0, 2.0, 5.0})
            for (const double sign : {1.0, -1.0}) {
                given(sign * longer, " cells along x and ", sign * shorter, " along z, then along z and x");
                expect("borders", law_of_changes(sign * longer, sign * shorter), 2 * longer, 1e-12);
                expect("borders", law_of_changes(sign * shorter, sign * longer), 2 * longer, 1e-12);
                given(sign * longer, " cells along x and ", -sign * shorter, " along z, then along z and x");
                expect("borders", law_of_changes(sign * longer, -sign * shorter), 2 * (longer + shorter),
                       1e-12);
                expect("borders", law_of_changes(-sign * shorter, sign * longer), 2 * (longer + shorter),
                       1e-12);
            }
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
