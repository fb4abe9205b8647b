#include "exercises/07_implicit_contact/6_rounds_run_away.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace enduring;

namespace {

constexpr double degree = std::numbers::pi / 180;

/// 1 kg between walls with the sine 0.6 and the cosine 0.8; k dt^2 = 50 kg.
Wedge by_hand(double mu = 0) { return {1, 5e5, std::asin(0.6), mu, 0.101, 0.01}; }

/// Walls that hardly give way: k dt^2 is 1e6 times the mass.
Wedge stiff(double degrees, double mu) { return {2, 2e10, degrees * degree, mu, 0.1, 0.01}; }

Wedge random_wedge(RandomInputs& random)
{
    const double mass = std::pow(10, random.number(-3, 3)), angle = random.number(5, 80) * degree;
    const double mu = random.number(0, 1.5), speed = std::pow(10, random.number(-3, 1)),
                 dt = std::pow(10, random.number(-3, -1));
    return {mass, mass * std::pow(10, random.number(-1, 3)) / (dt * dt), angle, mu, speed, dt};
}

std::string told(const Wedge& wedge)
{
    return in_words(wedge.mass, " kg, k ", wedge.stiffness, " N/m, walls at ", wedge.angle / degree,
                    " degrees, mu ", wedge.mu, ", free speed ", wedge.free_speed, " m/s, dt ", wedge.dt,
                    " s");
}

/// The limit above which friction holds the cube [N s].
double enough(const Wedge& wedge)
{
    const double spring = wedge.stiffness * wedge.dt * wedge.dt;
    return spring * std::cos(wedge.angle) * wedge.mass * wedge.free_speed / (wedge.mass + 2 * spring);
}

struct Round {
    Wedge wedge;
    double limit;  ///< [N s]
    WedgeMotion motion;
};

/// With a limit that holds the cube, or does not.
Round random_round(RandomInputs& random)
{
    const Wedge wedge = random_wedge(random);
    const double limit = random.number(0, 1.5) * enough(wedge);
    given(told(wedge), ", limit ", limit, " N s");
    return {wedge, limit, solved_with(wedge, limit)};
}

}  // namespace

TEST_CASE("round: held, sliding without friction, and sliding against a limit, by hand")
{
    given("1 kg, k dt^2 = 50 kg, walls with sine 0.6 and cosine 0.8, free speed 0.101 m/s; limit 1 N s");
    const WedgeMotion held = solved_with(by_hand(), 1);
    expect("speed", held.speed, 0.001, 1e-12, "m/s");
    expect("normal impulse", held.normal, 0.03, 1e-12, "N s");
    expect("friction", held.friction, 0.04, 1e-12, "N s");
    given("the same cube, limit 0");
    const WedgeMotion free = solved_with(by_hand(), 0);
    expect("speed", free.speed, 0.101 / 37, 1e-12, "m/s");
    expect("normal impulse", free.normal, 3.03 / 37, 1e-12, "N s");
    expect("friction", free.friction, 0, 1e-12, "N s");
    given("the same cube, limit 0.01 N s");
    const WedgeMotion slips = solved_with(by_hand(), 0.01);
    expect("speed", slips.speed, 0.085 / 37, 1e-12, "m/s");
    expect("normal impulse", slips.normal, 2.55 / 37, 1e-12, "N s");
    expect("friction", slips.friction, 0.01, 1e-12, "N s");
}

TEST_CASE("round: both walls take the momentum that the cube loses, whatever the wedge and the limit")
{
    RandomInputs random(76);
    for (int trial = 0; trial < 200; ++trial) {
        const auto [wedge, limit, motion] = random_round(random);
        const double momentum = wedge.mass * wedge.free_speed;
        expect(
            "momentum that the walls take",
            2 * (std::sin(wedge.angle) * motion.normal + std::cos(wedge.angle) * motion.friction) / momentum,
            wedge.mass * (wedge.free_speed - motion.speed) / momentum, 1e-9, "of m v*");
    }
}

TEST_CASE("round: springs push with k dt^2 times the speed along them, friction up to its limit")
{
    RandomInputs random(77);
    for (int trial = 0; trial < 200; ++trial) {
        const auto [wedge, limit, motion] = random_round(random);
        const double spring = wedge.stiffness * wedge.dt * wedge.dt, size = enough(wedge);
        expect("normal impulse over that of a held cube", motion.normal / size,
               spring * std::sin(wedge.angle) * motion.speed / size, 1e-9);
        expect("friction over that of a held cube", motion.friction / size,
               std::min(limit, spring * std::cos(wedge.angle) * motion.speed) / size, 1e-9);
    }
}

TEST_CASE("rounds: without friction the first round is the last one")
{
    given("1 kg, mu 0, at most 5 rounds");
    expect("rounds", rounds_needed(by_hand(), 1, 1e-9, 5), 1, 0);
}

TEST_CASE("rounds: friction that holds at once ends after three")
{
    given("walls at 40 degrees, mu 1.3, above the cotangent 1.19");
    expect("rounds", rounds_needed(stiff(40, 1.3), 1, 1e-9, 100), 3, 0);
    given("the same walls, at most 3 rounds");
    expect("rounds", rounds_needed(stiff(40, 1.3), 1, 1e-9, 3), 3, 0);
    given("the same walls, at most 2 rounds");
    expect("rounds, 0 where they are not enough", rounds_needed(stiff(40, 1.3), 1, 1e-9, 2), 0, 0);
}

TEST_CASE("rounds: each one with part 1 leaves the factor's part of the error")
{
    for (const double c : {0.1, 0.5, 0.8}) {
        const Wedge wedge = stiff(30, c * std::tan(30 * degree));
        int expected = 1;
        for (double left = wedge.mu * solved_with(wedge, 0).normal; left > 1e-7; left *= c)
            ++expected;
        given("walls at 30 degrees, mu ", wedge.mu, ": the factor is -", c, "; tolerance 1e-7 N s");
        expect("rounds", rounds_needed(wedge, 1, 1e-7, 1000), expected, 1);
    }
}

TEST_CASE("rounds: between the tangent and the cotangent they never end, though the cube slips")
{
    for (const double degrees : {10.0, 20.0, 30.0, 40.0}) {
        const double tangent = std::tan(degrees * degree);
        for (const double mu : {1.05 * tangent, 0.95 / tangent}) {
            given("walls at ", degrees, " degrees, mu ", mu, ", tolerance 1e-9 N s, at most 5000 rounds");
            expect("rounds, 0 where they do not end", rounds_needed(stiff(degrees, mu), 1, 1e-9, 5000), 0, 0);
        }
    }
}

TEST_CASE("factor: it is how the limit after a round follows the limit before, whatever the wedge")
{
    RandomInputs random(78);
    for (int trial = 0; trial < 100; ++trial) {
        const Wedge wedge = random_wedge(random);
        const double limit = 0.5 * enough(wedge);
        const double change = wedge.mu * (solved_with(wedge, limit).normal - solved_with(wedge, 0).normal);
        given(told(wedge));
        expect("factor", factor_of_a_round(wedge), change / limit, 1e-9 * (1 + std::abs(change / limit)));
    }
}

TEST_CASE("factor: between stiff walls it is minus mu over the tangent")
{
    for (const double degrees : {5.0, 30.0, 60.0}) {
        given("walls at ", degrees, " degrees, mu 0.5");
        expect("factor times the tangent",
               factor_of_a_round(stiff(degrees, 0.5)) * std::tan(degrees * degree), -0.5, 1e-3);
    }
}

TEST_CASE("best part: one change finds the limit, also where rounds run away")
{
    for (const double degrees : {10.0, 20.0, 30.0, 40.0})
        for (const double mu : {0.1, 0.3, 0.8}) {
            const Wedge wedge = stiff(degrees, mu);
            given("walls at ", degrees, " degrees, mu ", mu, ", tolerance 1e-9 N s");
            expect("rounds", rounds_needed(wedge, best_part(wedge), 1e-9, 100), 2, 0);
        }
}

TEST_CASE("best part: half of it leaves half of the error")
{
    const Wedge wedge = stiff(20, 0.8);
    int expected = 1;
    for (double left = wedge.mu * solved_with(wedge, 0).normal; left > 1e-7; left /= 2)
        ++expected;
    given("walls at 20 degrees, mu 0.8, half of the best part, tolerance 1e-7 N s");
    expect("rounds", rounds_needed(wedge, best_part(wedge) / 2, 1e-7, 1000), expected, 2);
}

TEST_CASE("measurement: rounds end up to the tangent of the angle")
{
    for (const double degrees : {10.0, 20.0, 30.0}) {
        double ends = 0, runs_away = 1 / std::tan(degrees * degree) - 0.05;
        for (int i = 0; i < 20; ++i) {
            const double mu = (ends + runs_away) / 2;
            (rounds_needed(stiff(degrees, mu), 1, 1e-9, 20000) > 0 ? ends : runs_away) = mu;
        }
        given("stiff walls at ", degrees, " degrees");
        expect("smallest coefficient for which rounds do not end", ends, std::tan(degrees * degree), 2e-3);
        say("walls at ", degrees, " degrees: rounds end up to mu = ", ends, ", you predicted ",
            predicted_mu(degrees * degree));
    }
}
