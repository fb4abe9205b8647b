
#include <doctest/doctest.h>

#include "common/experiments/verification/hard_verification.hpp"
#include "common/experiments/verification/inertia_verification.hpp"
#include "common/experiments/verification/mass_verification.hpp"
#include "common/experiments/verification/modal_verification.hpp"
#include "common/experiments/verification/spin_verification.hpp"
#include "common/experiments/verification/static_verification.hpp"
#include "common/experiments/verification/verification_bars.hpp"

#include <cmath>
#include <string>

using namespace enduring;
using namespace enduring::verification;

namespace {

double number(const Table& table, std::size_t row, std::size_t column)
{
    return std::get<double>(table.rows()[row][column]);
}

bool is(const Table& table, std::size_t row, const std::string& word)
{
    return std::get<std::string>(table.rows()[row][0]) == word;
}

}  // namespace

TEST_CASE(
    "lumped masses: row sums of the nodal basis are negative at the corners, those of the Bernstein basis never")
{
    const Table table = ways_of_lumping();
    CHECK(number(table, 0, 1) == doctest::Approx(-1.0 / 20));
    CHECK(number(table, 0, 2) == doctest::Approx(1.0 / 5));
    CHECK(number(table, 1, 1) == doctest::Approx(1.0 / 36));  // Hinton, Rock, Zienkiewicz 1976
    CHECK(number(table, 1, 2) == doctest::Approx(4.0 / 27));
    CHECK(number(table, 2, 1) == doctest::Approx(1.0 / 10));
    CHECK(number(table, 2, 2) == doctest::Approx(1.0 / 10));
}

TEST_CASE(
    "cantilever: quadratic elements meet beam theory with shear within 2%, linear ones on the same mesh lock")
{
    const Table table = cantilever();
    REQUIRE(table.rows().size() == 4);
    for (std::size_t row = 0; row < 4; ++row) {
        const double ratio = number(table, row, 5);
        CAPTURE(row);
        CAPTURE(ratio);
        if (is(table, row, "quadratic"))
            CHECK(std::abs(ratio - 1) <= (row == 3 ? 0.02 : 0.03));  // the finer and the coarser mesh
        else
            CHECK(ratio < 0.7);
    }
}

TEST_CASE(
    "locking: linear elements sag the less the nearer Poisson's ratio is to one half, and sideways along one diagonal")
{
    const Table table = locking();
    REQUIRE(table.rows().size() == 20);
    for (std::size_t row = 0; row < table.rows().size(); ++row) {
        CAPTURE(row);
        const bool six = std::get<std::string>(table.rows()[row][1]) == "six";
        const double ratio = number(table, row, 5), sideways = number(table, row, 6);
        if (is(table, row, "quadratic")) {
            CHECK(ratio > 0.8);
            CHECK(ratio < 1.01);
            CHECK(sideways < 2);
        } else {
            CHECK(ratio < 0.7);
            if (row % 5 > 1)  // from 0.3 on
                CHECK(ratio < number(table, row - 1, 5));
            CHECK((six ? sideways > 5 : sideways < 1e-6));
        }
    }
    CHECK(number(table, 0, 4) ==
          doctest::Approx(18).epsilon(0.02));  // by hand: q L^4 / (20 E I), and a little shear
}

TEST_CASE("bending: the first frequency of a slender bar is within 2% of Euler and Bernoulli's")
{
    const Table table = bending_frequency();
    int checked = 0;
    for (std::size_t row = 0; row < table.rows().size(); ++row)
        if (is(table, row, "quadratic")) {
            CAPTURE(row);
            CHECK(std::abs(number(table, row, 5) - 1) <= 0.02);
            ++checked;
        }
    CHECK(checked == 3);
    CHECK(number(table, 0, 5) > 1.5);  // linear elements lock
}

TEST_CASE(
    "torsion: quadratic elements, three across a square bar, are within 2% of Saint-Venant's first frequency" *
    doctest::test_suite("long simulation"))
{
    const Table table = torsion_frequency();
    double before = 2;
    for (std::size_t row = 0; row < table.rows().size(); ++row)
        if (is(table, row, "quadratic")) {
            CAPTURE(row);
            CHECK(number(table, row, 5) > 1);  // a section that cannot warp freely is too stiff
            CHECK(number(table, row, 5) < before);
            before = number(table, row, 5);
        }
    CHECK(before < 1.02);
    CHECK(number(table, 3, 6) < 0.8);  // lumped masses turn too slowly
}

TEST_CASE(
    "inertia: the mass matrix has the integral's for bars and bunnies, to rounding, and lumps at the nodes have up to three times that")
{
    const Table table = inertia_ratios();
    for (std::size_t row = 0; row < table.rows().size(); ++row) {
        CAPTURE(row);
        CHECK(std::abs(number(table, row, 5) - 1) <= 1e-12);
        for (std::size_t axis : {2u, 3u, 4u})
            CHECK(number(table, row, axis) > 1.005);
    }
    CHECK(number(table, 0, 2) == doctest::Approx(3));
    CHECK(number(table, 1, 2) == doctest::Approx(2));
}

TEST_CASE("inertia: the excess of lumped masses falls with the square of the cells")
{
    const Table table = inertia_over_cells();
    for (std::size_t row = 0; row < table.rows().size(); ++row) {
        const double across = static_cast<double>(std::get<long>(table.rows()[row][0]));
        CHECK(number(table, row, 1) - 1 == doctest::Approx(2 / (across * across)));
        CHECK(number(table, row, 2) - 1 == doctest::Approx(1 / (across * across)));
    }
}

TEST_CASE("convergence: the errors vanish with the orders 2 and 1 of linear, 3 and 2 of quadratic elements")
{
    const Table table = convergence_in_space();
    for (std::size_t row : {2u, 5u}) {
        const double order = is(table, row, "linear") ? 2 : 3;
        CAPTURE(row);
        CHECK(number(table, row, 4) == doctest::Approx(order).epsilon(0.1));
        CHECK(number(table, row, 5) == doctest::Approx(order - 1).epsilon(0.1));
    }
}

TEST_CASE("convergence: implicit Euler follows a mode of vibration with order 1 in the step")
{
    const Table table = convergence_in_time();
    const std::size_t last = table.rows().size() - 1;
    CHECK(number(table, last, 2) == doctest::Approx(1).epsilon(0.05));
    CHECK(number(table, last, 1) < 0.02);
}

TEST_CASE("spinning bar: the energy made in the first step is the stretch of a linearised rotation")
{
    for (double young : {1e5, 1e6})
        for (double omega_dt : {0.02, 0.05, 0.1, 0.2}) {
            CAPTURE(young);
            CAPTURE(omega_dt);
            const SpinGrowth growth = spin({.young = young, .omega_dt = omega_dt, .steps = 1});
            CHECK(growth.first_step > 0);
            CHECK(std::abs(growth.first_step / growth.first_step_formula - 1) <= 1e-7);
        }
}

TEST_CASE("spinning bar: up to |omega| dt = 0.05 the energy grows by at most 1% in all" *
          doctest::test_suite("long simulation"))
{
    for (double young : {1e5, 1e6, 2.5e6})
        for (double omega_dt : {0.0125, 0.025, 0.05}) {
            CAPTURE(young);
            CAPTURE(omega_dt);
            CHECK(spin({.young = young, .omega_dt = omega_dt, .steps = 1000}).largest <= 0.01);
        }
}

TEST_CASE("spinning bar: with frozen rotations the energy never grows")
{
    for (double omega_dt : {0.02, 0.1, 0.3}) {
        CAPTURE(omega_dt);
        CHECK(spin({.freeze_rotations = true, .omega_dt = omega_dt, .steps = 300}).largest <= 1e-10);
    }
}

TEST_CASE("spinning bar: its linear momentum stays zero to rounding")
{
    CHECK(spin({.omega_dt = 0.1}).linear_momentum <= 1e-13);
}

TEST_CASE(
    "twisted bar: let go at a long step it gains no energy with the neo-Hookean law, and more than it had with the corotated one" *
    doctest::test_suite("long simulation"))
{
    for (const Basis basis : both_bases) {
        CAPTURE(name_of(basis));
        const HardOutcome soft = twist_once({ElasticLaw::neo_hookean, basis, 1e6, 0.01}),
                          warped = twist_once({ElasticLaw::corotated, basis, 1e6, 0.01});
        CHECK(soft.gain == 0);
        CHECK(soft.inverted_held + soft.inverted_free == 0);
        CHECK(soft.left < 0.03);
        CHECK(warped.gain > warped.held);
    }
}
TEST_CASE("pressed block: let go at a long step it gains no energy, with any law at points" *
          doctest::test_suite("long simulation"))
{
    for (const ElasticLaw law : {ElasticLaw::corotated_at_points, ElasticLaw::neo_hookean}) {
        CAPTURE(name_of(law));
        const HardOutcome pressed = press_flat({law, Basis::linear, 1e6, 0.01});
        CHECK(pressed.gain == 0);
        CHECK(pressed.left < 1e-6);  // it is back in its shape
    }
}

TEST_CASE(
    "tumbling: one frame an element loses angular momentum of a quadratic bar, frames at points lose none")
{
    CHECK(lost_while_tumbling({ElasticLaw::corotated, Basis::quadratic, 1e5, 0.005}) > 1e-3);
    CHECK(lost_while_tumbling({ElasticLaw::corotated_at_points, Basis::quadratic, 1e5, 0.005}) < 1e-11);
    CHECK(lost_while_tumbling({ElasticLaw::neo_hookean, Basis::linear, 1e5, 0.005}) < 1e-11);
}
