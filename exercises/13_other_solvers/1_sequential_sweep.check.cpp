#include "exercises/13_other_solvers/1_sequential_sweep.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <algorithm>
#include <cmath>

using namespace enduring;

namespace {

Column random_column(RandomInputs& random, std::size_t cubes)
{
    Column column;
    for (std::size_t i = 0; i < cubes; ++i) {
        column.masses.push_back(std::exp(random.normal()));
        column.velocities.push_back(random.normal());
        column.impulses.push_back(std::abs(random.normal()));
    }
    return column;
}

double momentum(const Column& column)
{
    double sum = 0;
    for (std::size_t i = 0; i < column.masses.size(); ++i)
        sum += column.masses[i] * column.velocities[i];
    return sum;
}

}  // namespace

TEST_CASE("opening: of the ground, and of two cubes")
{
    const Column column{{1, 2}, {-3, 4}, {0, 0}};
    given("velocities -3 and 4 m/s");
    expect("contact 0 opens with", opening(column, 0), -3, 1e-14, "m/s");
    expect("contact 1 opens with", opening(column, 1), 7, 1e-14, "m/s");
}

TEST_CASE("contact: what approaches is stopped, and both cubes keep their momentum together")
{
    Column column{{1, 3}, {2, -2}, {0, 0}};
    given("1 kg below with 2 m/s, 3 kg above with -2 m/s");
    solve_contact(column, 1);
    expect("impulse", column.impulses[1], 3, 1e-14, "N s");
    expect("velocity below", column.velocities[0], -1, 1e-14, "m/s");
    expect("velocity above", column.velocities[1], -1, 1e-14, "m/s");
    Column ground{{2}, {-5}, {0}};
    given("2 kg come to the ground with 5 m/s");
    solve_contact(ground, 0);
    expect("impulse", ground.impulses[0], 10, 1e-14, "N s");
    expect("velocity", ground.velocities[0], 0, 1e-14, "m/s");
}

TEST_CASE("contact: one that opens gives back what it has pushed, and never pulls")
{
    Column enough{{2}, {1}, {5}};
    given("2 kg leave the ground with 1 m/s, and have been pushed by 5 N s");
    solve_contact(enough, 0);
    expect("impulse", enough.impulses[0], 3, 1e-14, "N s");
    expect("velocity", enough.velocities[0], 0, 1e-14, "m/s");
    Column little{{2}, {1}, {0.5}};
    given("the same, pushed by 0.5 N s");
    solve_contact(little, 0);
    expect("impulse", little.impulses[0], 0, 1e-14, "N s");
    expect("velocity", little.velocities[0], 0.75, 1e-14, "m/s");
}

TEST_CASE(
    "contact: in columns at random a contact ends still or open without impulse, and momentum stays inside")
{
    RandomInputs random(4);
    for (int run = 0; run < 200; ++run) {
        Column column = random_column(random, 4);
        const int i = 1 + run % 3;
        const double before = momentum(column);
        given("run ", run, ", contact ", i);
        solve_contact(column, i);
        const double impulse = column.impulses[static_cast<std::size_t>(i)], speed = opening(column, i);
        expect_that("the impulse is not negative", impulse >= 0);
        expect_that("it is still, or open without impulse",
                    std::abs(speed) <= 1e-12 || (speed > 0 && impulse == 0));
        expect("momentum", momentum(column), before, 1e-12, "N s");
    }
}

TEST_CASE("column: with all of its impulses it stands, and with none it falls")
{
    const Column stands = falling_column({1, 2, 3}, 0.01, 1), falls = falling_column({1, 2, 3}, 0.01, 0);
    given("cubes of 1, 2 and 3 kg, dt 0.01 s");
    for (std::size_t i = 0; i < 3; ++i) {
        expect("velocity with all", stands.velocities[i], 0, 1e-13, "m/s");
        expect("velocity with none", falls.velocities[i], -0.0981, 1e-13, "m/s");
        expect("impulse with none", falls.impulses[i], 0, 1e-14, "N s");
    }
    expect("impulse on the ground", stands.impulses[0], 6 * 0.0981, 1e-13, "N s");
    expect("impulse below the top", stands.impulses[2], 3 * 0.0981, 1e-13, "N s");
    const Column half = falling_column({1, 2, 3}, 0.01, 0.5);
    given("half of the impulses");
    expect("velocity of the middle", half.velocities[1], -0.0981 / 2, 1e-13, "m/s");
}

TEST_CASE("sweeps: none for a column that stands, and more the higher it is and the heavier its top")
{
    const auto needed = [](const std::vector<double>& masses, double part) {
        Column column = falling_column(masses, 0.01, part);
        return sweeps_needed(column, 1e-6);
    };
    given("ten equal cubes with all of their impulses");
    expect("sweeps", needed(std::vector<double>(10, 1), 1), 0, 0, "");
    given("one cube");
    expect("sweeps", needed({1}, 0), 1, 0, "");
    given("what is left is below the tolerance");
    Column column = falling_column(std::vector<double>(5, 1), 0.01, 0);
    const int sweeps = sweeps_needed(column, 1e-6);
    for (int i = 0; i < 5; ++i)
        expect_that("no contact approaches", opening(column, i) >= -1e-6);
    Column again = falling_column(std::vector<double>(5, 1), 0.01, 0);
    for (int n = 1; n < sweeps; ++n)
        for (int i = 0; i < 5; ++i)
            solve_contact(again, i);
    double fastest = 0;
    for (int i = 0; i < 5; ++i)
        fastest = std::max(fastest, -opening(again, i));
    expect_that("one sweep less is not enough", fastest > 1e-6);
    say("to a micrometre per second: ", needed(std::vector<double>(2, 1), 0), " sweeps for 2 cubes, ",
        needed(std::vector<double>(10, 1), 0), " for 10, ", needed({1, 100}, 0), " for 100 kg on 1 kg");
}
