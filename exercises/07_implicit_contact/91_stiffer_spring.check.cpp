#include "exercises/07_implicit_contact/91_stiffer_spring.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <algorithm>
#include <cmath>

using namespace enduring;

namespace {

double force(const Spring& spring, double depth) { return -spring.k * std::min(0.0, depth - spring.rest); }

}  // namespace

TEST_CASE("stiffness: by the mass, by the load, and not without end")
{
    const double mass = 2.5;
    const double wanted = 1e-5;
    const double dt = 0.01;
    const double least = 100 * mass / dt / dt;
    given("a pair of ", mass, " kg, a wanted depth of ", wanted, " m, a step of ", dt, " s");
    expect("without a load", asked_stiffness({mass, 0, wanted}, dt) / least, 1, 1e-12);
    expect("with seven times the load that the mass alone bears",
           asked_stiffness({mass, 7 * least * wanted, wanted}, dt) / least, 7, 1e-9);
    expect("with a load beyond all bounds", asked_stiffness({mass, 1e9 * least * wanted, wanted}, dt) / least,
           1e5, 1e-4);
}

TEST_CASE("energy: a parabola below the rest offset, and nothing above")
{
    const double k = 3e4;
    const double rest = -0.02;
    given("a spring of ", k, " N/m with its rest offset at ", rest, " m");
    expect("energy 3 mm below the rest offset", energy({k, rest}, rest - 0.003), 0.5 * k * 9e-6, 1e-9, "J");
    expect("energy 3 mm above", energy({k, rest}, rest + 0.003), 0, 0, "J");
}

TEST_CASE("another stiffness: the force of a pressed spring stays, also a rest offset that is not pressed")
{
    RandomInputs random(71);
    double off = 0, moved = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const Spring spring{random.number(1e3, 1e6), random.number(-0.1, 0.05)};
        const double k = random.number(1e3, 1e6), pressed = random.number(1e-4, 0.1);
        const double before = force(spring, spring.rest - pressed);
        const Spring other = with_stiffness(spring, k, spring.rest - pressed);
        off = std::max(
            off, std::abs(force(other, spring.rest - pressed) - before) / before + std::abs(other.k - k) / k);
        moved = std::max(moved,
                         std::abs(with_stiffness(spring, k, spring.rest + pressed).rest - spring.rest));
    }
    given("200 springs and other stiffnesses");
    expect("largest change of the force, over the force", off, 0, 1e-9);
    expect("largest change of a rest offset that is not pressed", moved, 0, 0, "m");
}

TEST_CASE("adapted: stiffer at once, softer only where it is more than twice as stiff")
{
    const double mass = 1.2;
    const double dt = 0.005;
    const double k = 100 * mass / dt / dt;
    const Pair pair{mass, 5 * k * 1e-5, 1e-5};
    given("a pair of ", mass, " kg that asks for five times its least stiffness");
    for (const auto& [now, then] :
         {std::pair{1.0, 5.0}, {4.9, 5.0}, {5.1, 5.1}, {9.9, 9.9}, {10.1, 5.0}, {40.0, 5.0}})
        expect(in_words("from ", now, " times the least stiffness, then"),
               adapted({now * k, -0.01}, pair, -0.0101, dt).k / k, then, 1e-9);
    int changed = 0;
    for (const double part : {1.0, 4.9, 5.1, 9.9, 10.1, 40.0})
        changed += adapted({part * k, -0.01}, pair, -0.0101, dt).k != part * k ? 1 : 0;
    say(changed, " of 6 springs change their stiffness");
    const Spring stiffer = adapted({k, 0}, pair, -1e-4, dt);
    expect("its force, over that before", force(stiffer, -1e-4) / (k * 1e-4), 1, 1e-9);
}

TEST_CASE("adapted: loads that come and go bring no energy")
{
    const double mass = 0.8;
    const double wanted = 2e-5;
    const double dt = 0.01;
    const double k = 100 * mass / dt / dt;
    RandomInputs random(72);
    double most = 0;
    for (int run = 0; run < 20; ++run) {
        Spring spring{k, 0};
        double brought = 0;
        for (int step = 0; step < 50; ++step) {
            const double load = k * wanted * std::pow(10, random.number(-1, 3));
            const double depth = spring.rest - load / spring.k;
            const Spring then = adapted(spring, {mass, load, wanted}, depth, dt);
            brought += energy(then, depth) - energy(spring, depth);
            spring = then;
        }
        most = std::max(most,
                        (brought - 0.5 * wanted * wanted * (k - spring.k)) / (0.5 * wanted * wanted * k));
    }
    given(
        "20 runs with 50 random loads; the change of energy less that of the stiffness, over the energy of the first spring");
    expect_that("it is never positive", most <= 1e-9);
}

TEST_CASE("faded: a tenth in a step, and no faster than a speed")
{
    const double fastest = 0.3;
    const double dt = 0.01;
    given("a fastest speed of ", fastest, " m/s, a step of ", dt, " s");
    expect("a shallow rest offset, after a step", faded(-fastest * dt, fastest, dt), -0.9 * fastest * dt,
           1e-15, "m");
    expect("a deep one", faded(-100 * fastest * dt, fastest, dt), -99 * fastest * dt, 1e-12, "m");
    expect("one above the surface", faded(0.02, fastest, dt), 0.02, 0, "m");
    double rest = -0.25;
    int steps = 0;
    for (; rest < -1e-4 && steps < 10000; ++steps)
        rest = faded(rest, fastest, dt);
    const double turn = 10 * fastest * dt;  // where both rules are equally fast
    const int expected = static_cast<int>(std::ceil((0.25 - turn) / (fastest * dt)) +
                                          std::ceil(std::log(1e-4 / turn) / std::log(0.9)));
    expect("steps from 25 cm to a tenth of a millimetre", steps, expected, 2);
}
