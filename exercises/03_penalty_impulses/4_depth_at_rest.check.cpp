#include "exercises/03_penalty_impulses/4_depth_at_rest.hpp"
#include "exercises/checking.hpp"

#include <cmath>

using namespace enduring;

namespace {

RestingCube cube_of(int cells, double dt = 0.01, PenaltyMethod method = PenaltyMethod::continuous)
{
    RestingCube cube;
    cube.cells = cells;
    cube.dt = dt;
    cube.method = method;
    return cube;
}

std::string name_of(const RestingCube& cube)
{
    return "a cube of 20 kg, k = 2000 N/m a pair, dt = " + readable(cube.dt) +
           " s, cells a side: " + readable(cube.cells) +
           (cube.method == PenaltyMethod::continuous ? ", continuous" : ", discrete");
}

/// What n springs under the cube would give at rest [mm].
double springs(int pairs) { return 1000 * 20 * 9.81 / (pairs * 2000.0); }

}  // namespace

TEST_CASE("prediction: a number is written down")
{
    expect_that("the predicted factor is a positive number",
                predicted_factor() > 0 && std::isfinite(predicted_factor()));
}

TEST_CASE(
    "measurement: a cube on its four corners lies as deep as four springs are pressed, but for half of g dt^2")
{
    given(name_of(cube_of(1)));
    expect("depth", 1000 * depth_at_rest(cube_of(1)), springs(4) - 0.5 * 9810 * 0.01 * 0.01, 0.01, "mm");
}

TEST_CASE("measurement: with the discrete method all of g dt^2 is missing from the depth")
{
    const RestingCube cube = cube_of(1, 0.02, PenaltyMethod::discrete);
    given(name_of(cube));
    expect("depth", 1000 * depth_at_rest(cube), springs(4) - 9810 * 0.02 * 0.02, 0.01, "mm");
}

TEST_CASE(
    "measurement: half the step damps half as much, and at the end of the scene the cube still swings a little")
{
    // The swing falls by exp(-zeta omega t) = exp(-5) of 24 mm in the 10 s of the scene: zeta = k' dt / (4
    // sqrt(k' m)), k' of four pairs.
    const RestingCube cube = cube_of(1, 0.005);
    given(name_of(cube));
    expect("depth", 1000 * depth_at_rest(cube), springs(4) - 0.5 * 9810 * 0.005 * 0.005, 24.5 * std::exp(-5),
           "mm");
}

TEST_CASE("factor: the finer cube lies seven times less deep, not four times")
{
    given(name_of(cube_of(1)), ", and 4 cells a side");
    // Depths of 4 and of 25 springs, both less the part that is looked ahead.
    const double ahead = 0.5 * 9810 * 0.01 * 0.01;
    expect("depth over depth", measured_factor(cube_of(1), 4), (springs(4) - ahead) / (springs(25) - ahead),
           0.05);
    say("1 cell a side: ", 1000 * depth_at_rest(cube_of(1)), " mm, by the law ",
        1000 * law_of_depth(cube_of(1)), " mm");
    say("4 cells a side: ", 1000 * depth_at_rest(cube_of(4)), " mm, by the law ",
        1000 * law_of_depth(cube_of(4)), " mm");
    say("4 cells a side lie ", measured_factor(cube_of(1), 4), " times less deep");
}

TEST_CASE("factor: it is measured, and only the cells are others")
{
    RestingCube swinging = cube_of(1, 0.005), wider = swinging;
    wider.cells = 2;
    given(name_of(swinging), ", and 2 cells a side");
    expect("depth over depth", measured_factor(swinging, 2), depth_at_rest(swinging) / depth_at_rest(wider),
           1e-6);

    RestingCube cube = cube_of(2, 0.02, PenaltyMethod::discrete), finer = cube;
    cube.mass = finer.mass = 30;
    cube.stiffness = finer.stiffness = 2500;
    finer.cells = 3;
    given("a cube of 30 kg, k = 2500 N/m a pair, dt = 0.02 s, discrete, of 2 and of 3 cells a side");
    expect("depth over depth", measured_factor(cube, 3), depth_at_rest(cube) / depth_at_rest(finer), 1e-6);
}

TEST_CASE("law: for very short steps a cube on four corners presses four springs")
{
    given(name_of(cube_of(1, 1e-6)));
    expect("depth", 1000 * law_of_depth(cube_of(1, 1e-6)), springs(4), 1e-6, "mm");
}

TEST_CASE("law: a finer cube presses one spring for each vertex of its sole")
{
    for (const int cells : {2, 4, 10}) {
        const RestingCube cube = cube_of(cells, 1e-6);
        given(name_of(cube));
        expect("depth", 1000 * law_of_depth(cube), springs((cells + 1) * (cells + 1)), 1e-6, "mm");
    }
}

TEST_CASE("law: twice the mass presses twice as deep, and a stiffer pair less, in proportion")
{
    RestingCube heavy = cube_of(2, 1e-6), stiff = cube_of(2, 1e-6);
    heavy.mass = 40;
    stiff.stiffness = 8000;
    given("cells a side: 2, dt = 1e-6 s; 20 kg and 40 kg, 2000 N/m and 8000 N/m");
    expect("depth of 40 kg", 1000 * law_of_depth(heavy), 2 * springs(9), 1e-6, "mm");
    expect("depth at 8000 N/m", 1000 * law_of_depth(stiff), springs(9) / 4, 1e-6, "mm");
}

TEST_CASE("law: no cube lies deeper than its springs say")
{
    const RestingCube cube = cube_of(1, 0.02);
    given(name_of(cube));
    const double depth = 1000 * law_of_depth(cube);
    expect_that("the depth (" + readable(depth) + " mm) is at most that of four springs (" +
                    readable(springs(4)) + " mm)",
                depth <= springs(4) + 1e-9);
}

TEST_CASE(
    "law: a longer step makes the depth smaller, by the square of the step, discrete twice as much as continuous")
{
    const double short_step = law_of_depth(cube_of(1, 1e-6));
    for (const double dt : {0.01, 0.02}) {
        given("cells a side: 1, dt = 1e-6 s and ", dt, " s");
        expect("missing, continuous", 1000 * (short_step - law_of_depth(cube_of(1, dt))),
               0.5 * 9810 * dt * dt, 1e-6, "mm");
        expect("missing, discrete",
               1000 * (short_step - law_of_depth(cube_of(1, dt, PenaltyMethod::discrete))), 9810 * dt * dt,
               1e-6, "mm");
    }
}

TEST_CASE("law: measurement and law agree, for every cut, step and method")
{
    for (const RestingCube& cube :
         {cube_of(1, 0.02), cube_of(2), cube_of(3, 0.01, PenaltyMethod::discrete), cube_of(6, 0.005)}) {
        given(name_of(cube));
        const double law = 1000 * law_of_depth(cube), measured = 1000 * depth_at_rest(cube);
        expect_that("law and measurement agree to 0.02 mm; your law says " + readable(law) +
                        " mm, your measurement " + readable(measured) + " mm",
                    std::abs(measured - law) <= 0.02);
    }
}

TEST_CASE("comparison: the measured factor is the law's")
{
    say("you predicted ", predicted_factor());
    const double law = law_of_depth(cube_of(1)) / law_of_depth(cube_of(4)),
                 measured = measured_factor(cube_of(1), 4);
    given(name_of(cube_of(1)), ", and 4 cells a side");
    expect_that("both factors agree to 0.05; your law says " + readable(law) + ", your measurement " +
                    readable(measured),
                std::abs(measured - law) <= 0.05);
}
