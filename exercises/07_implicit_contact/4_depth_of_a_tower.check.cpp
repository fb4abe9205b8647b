#include "exercises/07_implicit_contact/4_depth_of_a_tower.hpp"
#include "exercises/checking.hpp"

#include <Eigen/LU>

#include <algorithm>

using namespace enduring;

namespace {

const Tower single{{1, 1, 10}};
const Tower four{{1, 1, 10}, {0.9, 1, 10}, {0.8, 1, 10}, {0.7, 1, 10}};
const Tower mixed{{2, 1, 5}, {1.5, 0.5, 40}, {0.3, 0.1, 2}, {0.2, 0.3, 30}};
const Tower small{{0.1, 0.05, 0.3}, {0.07, 0.1, 0.1}, {0.05, 0.02, 0.01}};

std::string told(const Tower& tower)
{
    std::string words = "radius, height and mass from below:";
    for (const TowerPiece& piece : tower)
        words += in_words(" ", piece.radius, " m, ", piece.height, " m, ", piece.mass, " kg;");
    return words;
}

StiffnessChoice wanting(double depth)
{
    StiffnessChoice choice;
    choice.wanted_depth = depth;
    return choice;
}

/// What an impulse along n at a corner of the upper piece changes there, by the mesh's own inertia.
double answer_at(const TowerPiece& piece, double lever)
{
    const SurfaceMesh mesh = prism(piece.radius, -piece.height / 2, piece.height / 2);
    const MassProperties properties = with_mass(mass_properties(mesh, 1000), piece.mass);
    const Vec3 turn = Vec3(lever, 0, 0).cross(Vec3::UnitY());
    return 1 / properties.mass + turn.dot(properties.inertia.inverse() * turn);
}

Eigen::VectorXd vector_of(const std::vector<double>& numbers)
{
    return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

/// Depths in micrometres.
void expect_depths(const std::string& what, const std::vector<double>& got,
                   const std::vector<double>& expected, double part)
{
    expect("number of " + what, got.size(), expected.size(), 0);
    if (got.size() == expected.size())
        expect(what, Eigen::VectorXd(1e6 * vector_of(got)), Eigen::VectorXd(1e6 * vector_of(expected)),
               part * 1e6 * vector_of(expected).norm(), "um");
}

}  // namespace

TEST_CASE("prediction: a factor is written down")
{
    expect_that("the factor is positive", predicted_factor() > 0 && std::isfinite(predicted_factor()));
}

TEST_CASE("loads: a joint carries what stands above it, and the lowest one everything")
{
    given(told(mixed), " g 9.81 m/s^2");
    const std::vector<double> expected{77 * 9.81, 72 * 9.81, 32 * 9.81, 30 * 9.81}, got = loads_of(mixed);
    expect("number of loads", got.size(), 4, 0);
    if (got.size() == 4)
        expect("loads", vector_of(got), vector_of(expected), 1e-9, "N");
}

TEST_CASE("mass: a corner on the ground feels its piece, which turns as well")
{
    for (const TowerPiece& piece : {TowerPiece{1, 1, 10}, TowerPiece{0.2, 3, 4}, TowerPiece{5, 0.1, 1000}}) {
        given(told({piece}));
        expect("mass", mass_of_pair({piece}, 0), 1 / answer_at(piece, piece.radius), 1e-9 * piece.mass, "kg");
    }
}

TEST_CASE("mass: a corner on another piece feels both, and both turn by the lever of this corner")
{
    for (const Tower& tower : {four, mixed, small})
        for (std::size_t joint = 1; joint < tower.size(); ++joint) {
            const double lever = tower[joint].radius;
            const double expected = 1 / (answer_at(tower[joint], lever) + answer_at(tower[joint - 1], lever));
            given(told(tower), " joint ", joint);
            expect("mass", mass_of_pair(tower, joint), expected, 1e-9 * expected, "kg");
        }
}

TEST_CASE(
    "law: where the mass decides, the depth is that of the springs, and where the load does, the wanted one")
{
    const double load = 98.1 / 3, stiffness = 100 * (10 / 5.8) / 1e-4;
    given(told(single), " wanted depth 1 mm, dt 0.01 s");
    expect_depths("depths [um]", law_of_depths(single, wanting(1e-3), 0.01), {load / stiffness}, 1e-9);
    given(told(single), " wanted depth 1 um, dt 0.01 s");
    expect_depths("depths [um]", law_of_depths(single, wanting(1e-6), 0.01), {1e-6}, 1e-9);
    const Tower ton_on_top{{1, 1, 1}, {0.8, 1, 1000}};
    given(told(ton_on_top), " wanted depth 10 um, dt 0.01 s");
    expect_depths("depths [um]", law_of_depths(ton_on_top, wanting(1e-5), 0.01), {1e-5, 1e-5}, 1e-9);
}

TEST_CASE(
    "law: in a stiff world neither mass nor size matters, and a step twice as long means four times as deep")
{
    const std::vector<double> depths = law_of_depths(four, wanting(1), 0.002);
    Tower large = four;
    for (TowerPiece& piece : large)
        piece = {1000 * piece.radius, 1000 * piece.height, 50 * piece.mass};
    given(told(large), " wanted depth 1 m, dt 0.002 s");
    expect_depths("depths [um], as those of a tower a thousandth as large",
                  law_of_depths(large, wanting(1), 0.002), depths, 1e-9);
    std::vector<double> deeper = depths;
    for (double& depth : deeper)
        depth *= 4;
    given(told(four), " wanted depth 1 m, dt 0.004 s");
    expect_depths("depths [um], as four times those with 0.002 s", law_of_depths(four, wanting(1), 0.004),
                  deeper, 1e-9);
}

TEST_CASE("measurement: a piece alone comes to rest at g dt^2 / 100 times what its turning makes of it")
{
    for (const double dt : {0.002, 0.01, 1.0 / 60}) {
        given(told(single), " wanted depth 1 mm, dt ", dt, " s, 2 s");
        expect_depths("depths [um]", measured_depths(single, wanting(1e-3), dt, 2),
                      {tower_gravity * dt * dt / 100 * 5.8 / 3}, 1e-3);
    }
}

TEST_CASE("measurement: it takes the choice of stiffness that it is given")
{
    StiffnessChoice soft = wanting(1e-3);
    soft.k_dt2_over_m = 25;
    given(told(single), " h 25, wanted depth 1 mm, dt 0.01 s, 2 s");
    expect_depths("depths [um]", measured_depths(single, soft, 0.01, 2),
                  {tower_gravity * 1e-4 / 25 * 5.8 / 3}, 1e-3);
}

TEST_CASE("measurement: it ends after the seconds that it is given, also while the piece still swings")
{
    StiffnessChoice soft = wanting(1);
    soft.k_dt2_over_m = 0.05;
    for (const double dt : {0.001, 0.002})
        for (const int steps : {0, 1, 20}) {
            // Three springs of k = 0.05 (m / 5.8) / dt^2 under one piece, and the implicit step of chapter 7.
            const double h = 3 * 0.05 / 5.8;
            double height = 1e-9, velocity = 0;
            for (int step = 0; step < steps; ++step) {
                const double fallen = velocity - tower_gravity * dt;
                const bool pressed = height + dt * fallen < 0;
                velocity = pressed ? (fallen - h * height / dt) / (1 + h) : fallen;
                height += dt * velocity;
            }
            given(told(single), " h 0.05, wanted depth 1 m, dt ", dt, " s, ", steps, " steps");
            const std::vector<double> depths = measured_depths(single, soft, dt, steps * dt);
            expect("number of depths", depths.size(), 1, 0);
            if (depths.size() == 1)
                expect("depth", 1e6 * depths[0], -1e6 * height, 1e-3 * std::abs(1e6 * height) + 1e-3, "um");
        }
}

TEST_CASE(
    "law: where masses decide, every tower comes to rest as the law says, whatever its sizes, masses and step")
{
    for (const Tower& tower : {four, mixed, small})
        for (const double dt : {0.002, 0.01}) {
            given(told(tower), " wanted depth 1 mm, dt ", dt, " s, measured after 2 s");
            const std::vector<double> law = law_of_depths(tower, wanting(1e-3), dt);
            expect_depths("depths [um], yours against your law", measured_depths(tower, wanting(1e-3), dt, 2),
                          law, 2e-3);
        }
    const std::vector<double> law = law_of_depths(four, wanting(1e-3), 0.01),
                              measured = measured_depths(four, wanting(1e-3), 0.01, 2);
    for (std::size_t joint = 0; joint < four.size() && joint < law.size() && joint < measured.size(); ++joint)
        say("joint ", joint, " of four: ", 1e6 * measured[joint], " um, by the law ", 1e6 * law[joint],
            " um");
}

TEST_CASE("law: where a load decides, no joint is deeper than the law says")
{
    double alone = 0, pressed = 0;
    for (const double dt : {0.01, 1.0 / 60})
        for (const double ton : {30.0, 1000.0}) {
            const Tower tower{{1, 1, 1}, {0.8, 1, ton}};
            given(told(tower), " wanted depth 0.01 mm, dt ", dt, " s, 4 s");
            const std::vector<double> law = law_of_depths(tower, wanting(1e-5), dt),
                                      measured = measured_depths(tower, wanting(1e-5), dt, 4);
            expect("number of depths", measured.size(), law.size(), 0);
            for (std::size_t joint = 0; joint < std::min(law.size(), measured.size()); ++joint)
                expect_that("joint " + readable(joint) + ", " + readable(1e6 * measured[joint]) +
                                " um deep, is pressed, and not deeper than " + readable(1e6 * law[joint]) +
                                " um",
                            measured[joint] > 0.3 * law[joint] && measured[joint] < 1.02 * law[joint]);
            if (dt == 0.01 && ton == 1000 && !measured.empty())
                pressed = measured[0];
        }
    const std::vector<double> without = measured_depths({{1, 1, 1}}, wanting(1e-5), 0.01, 4);
    if (!without.empty())
        alone = without[0];
    say("1 kg alone: ", 1e6 * alone, " um; under a ton: ", 1e6 * pressed, " um");
    say("you predicted a factor of ", predicted_factor());
}
