#include "exercises/01_particle_plane/3_stiffness_for_a_step.hpp"
#include "chapters/01_particle_plane/particle.hpp"
#include "chapters/01_particle_plane/settling.hpp"
#include "exercises/checking.hpp"

#include <limits>
#include <stdexcept>
#include <vector>

namespace enduring {
namespace {

const std::vector<double> masses = {0.7, 0.2, 5};  // kg

bool settles_with(PenaltyMethod method, double safety, double times)
{
    ParticleProblem problem;
    problem.mass = 0.2;
    problem.dt = 0.01;
    problem.method = method;
    problem.stiffness = times * stiffness_for_step(masses, problem.dt, method, safety);
    return settles(problem);
}

}  // namespace

TEST_CASE("stiffness: it goes with the lightest mass over the square of the step")
{
    given("masses 0.7, 0.2 and 5 kg, dt 0.01 s, continuous, safety 0.9");
    expect("k", stiffness_for_step(masses, 0.01, PenaltyMethod::continuous, 0.9), 3600.0, 1e-6, "N/m");
    given("masses 0.7, 0.2 and 5 kg, dt 0.02 s, continuous, safety 0.9");
    expect("k", stiffness_for_step(masses, 0.02, PenaltyMethod::continuous, 0.9), 900.0, 1e-6, "N/m");
}

TEST_CASE("stiffness: the discrete method allows two thirds of the continuous one's")
{
    given("masses 0.7, 0.2 and 5 kg, dt 0.01 s, discrete, safety 0.9");
    expect("k", stiffness_for_step(masses, 0.01, PenaltyMethod::discrete, 0.9), 2400.0, 1e-6, "N/m");
}

TEST_CASE("stiffness: from milligrams to tonnes and from microseconds to minutes k dt^2 / m is the same")
{
    for (const double unit : {1e-6, 1.0, 1e6})
        for (const double dt : {1e-6, 60.0}) {
            const std::vector<double> of = {7 * unit, 3 * unit, 2 * unit, 5 * unit};
            given("masses ", of[0], ", ", of[1], ", ", of[2], " and ", of[3], " kg, dt ", dt,
                  " s, continuous, safety 0.5");
            const double k = stiffness_for_step(of, dt, PenaltyMethod::continuous, 0.5);
            expect("k dt^2 over the smallest mass", k * dt * dt / of[2], 1.0, 1e-12);
        }
}

TEST_CASE("stiffness: the lightest particle settles with it, and not with a little more than safety 1 gives")
{
    for (const PenaltyMethod method : {PenaltyMethod::discrete, PenaltyMethod::continuous}) {
        given(short_name(method), ", dt 0.01 s, 0.2 kg, dropped from 0.1 m");
        expect_that("it settles with safety 0.9", settles_with(method, 0.9, 1));
        expect_that("it does not settle with 1.05 times the stiffness of safety 1",
                    !settles_with(method, 1, 1.05));
    }
}

TEST_CASE("stiffness: arguments outside their range are refused")
{
    const auto k = [](const std::vector<double>& of, double dt, double safety) {
        return stiffness_for_step(of, dt, PenaltyMethod::continuous, safety);
    };
    const auto refuses = [&](const std::vector<double>& of, double dt, double safety) {
        try {
            k(of, dt, safety);
        } catch (const std::invalid_argument&) {
            return true;
        }
        return false;
    };
    k(masses, 0.01, 1);  // all in range
    expect_that("no particle at all is refused", refuses({}, 0.01, 0.9));
    expect_that("a mass of 0 kg is refused", refuses({1, 0}, 0.01, 0.9));
    expect_that("a step of 0 s is refused", refuses(masses, 0, 0.9));
    expect_that("a safety of 0 is refused", refuses(masses, 0.01, 0));
    expect_that("a safety of 1.1 is refused", refuses(masses, 0.01, 1.1));
    expect_that("a negative mass is refused", refuses({1, -0.2, 5}, 0.01, 0.9));
    expect_that("a negative step is refused", refuses(masses, -0.01, 0.9));
    expect_that("a negative safety is refused", refuses(masses, 0.01, -0.9));
}

TEST_CASE("stiffness: what is not a number is not positive, and is refused")
{
    const double not_a_number = std::numeric_limits<double>::quiet_NaN();
    const auto refuses = [](const std::vector<double>& of, double dt, double safety) {
        try {
            stiffness_for_step(of, dt, PenaltyMethod::continuous, safety);
        } catch (const std::invalid_argument&) {
            return true;
        }
        return false;
    };
    expect_that("a step that is NaN is refused", refuses(masses, not_a_number, 0.9));
    expect_that("a safety that is NaN is refused", refuses(masses, 0.01, not_a_number));
    expect_that("a mass that is NaN is refused, in any place", refuses({not_a_number, 1}, 0.01, 0.9) &&
                                                                   refuses({1, not_a_number}, 0.01, 0.9) &&
                                                                   refuses({2, not_a_number, 1}, 0.01, 0.9));
}

TEST_CASE("rest: the depth is where a simulation with that stiffness ends")
{
    for (const PenaltyMethod method : {PenaltyMethod::discrete, PenaltyMethod::continuous}) {
        ParticleProblem problem;
        problem.mass = 0.2;
        problem.dt = 0.01;
        problem.method = method;
        problem.stiffness = 1600;  // two thirds of 2400, four ninths of 3600 at safety 0.9
        const double safety = method == PenaltyMethod::discrete ? 0.6 : 0.4;
        given(short_name(method), ", dt 0.01 s, safety ", safety, ", g 9.81 m/s^2");
        const double found = -1000 * simulate({0, 0}, problem, 3000).height;
        expect("depth", 1000 * depth_at_rest(problem.dt, method, safety, 9.81), found, 1e-6, "mm");
    }
}

TEST_CASE(
    "rest: the depth is that of the spring less what is looked ahead, also where this is above the plane")
{
    const double dt = 0.01, mass = 0.2;
    const std::vector<double> one = {mass};
    for (const double gravity : {1.62, 9.81})
        for (const double safety : {0.3, 0.9})
            for (const PenaltyMethod method : {PenaltyMethod::discrete, PenaltyMethod::continuous}) {
                given(short_name(method), ", dt ", dt, " s, safety ", safety, ", g ", gravity, " m/s^2");
                const double ahead = method == PenaltyMethod::discrete ? 1 : 0.5;
                expect("depth", 1000 * depth_at_rest(dt, method, safety, gravity),
                       1000 * (mass * gravity / stiffness_for_step(one, dt, method, safety) -
                               ahead * gravity * dt * dt),
                       1e-9, "mm");
            }
}

TEST_CASE("rest: the step for a depth is that of a particle which rests there, from nanometres to kilometres")
{
    for (const double gravity : {1.62, 9.81})
        for (const double safety : {0.3, 0.9})
            for (const double depth : {1e-9, 1e-3, 1e3}) {
                given("depth ", depth, " m, safety ", safety, ", g ", gravity, " m/s^2");
                const double dt = step_for_depth(depth, safety, gravity);
                expect("depth at rest with that step over the wanted one",
                       depth_at_rest(dt, PenaltyMethod::continuous, safety, gravity) / depth, 1.0, 1e-9);
            }
}

TEST_CASE("rest: the step for a depth gives that depth back")
{
    for (const double depth : {1e-3, 1e-5}) {
        given("depth ", depth, " m, safety 0.9, g 9.81 m/s^2");
        const double dt = step_for_depth(depth, 0.9, 9.81);
        expect("g dt^2 (1 / (2 safety) - 1/2)", 9.81 * dt * dt * (1 / 1.8 - 0.5), depth, 1e-9 * depth, "m");
    }
    const double k = stiffness_for_step(masses, 0.01, PenaltyMethod::continuous, 0.9);
    say("dt 0.01 s, lightest 0.2 kg, safety 0.9: k = ", readable(k),
        " N/m, and any particle of that mass rests ",
        1000 * depth_at_rest(0.01, PenaltyMethod::continuous, 0.9, 9.81), " mm deep");
    say("a depth of 0.01 mm needs dt = ", step_for_depth(1e-5, 0.9, 9.81), " s");
}

}  // namespace enduring
