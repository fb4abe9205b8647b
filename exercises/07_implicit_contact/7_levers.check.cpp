#include "exercises/07_implicit_contact/7_levers.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <cmath>
#include <complex>
#include <initializer_list>
#include <numbers>
#include <utility>
#include <vector>

using namespace enduring;

namespace {

using Eigen::Vector2d;
using Complex = std::complex<double>;

constexpr double pi = std::numbers::pi;
RandomInputs generator(77);

double random_number() { return generator.number(-1, 1); }

Vector2d random_vector()
{
    const double x = random_number(), y = random_number();
    return {x, y};
}

/// The lever by another program: the plane as the complex numbers.
Complex lever_of(const Vector2d& vertex, double turn, double tau)
{
    return Complex(vertex.x(), vertex.y()) * (1 - tau + tau * std::polar(1.0, turn));
}

double moment(const Complex& lever, const Vector2d& impulse)
{
    return (std::conj(lever) * Complex(impulse.x(), impulse.y())).imag();
}

/// A solid disk of 0.1 m.
Wheel disk(double spin, double mass = 2) { return {{mass, mass * 0.01 / 2, spin}, 0.1}; }

double rolling_inertia(const Wheel& wheel)
{
    return wheel.body.inertia + wheel.body.mass * wheel.radius * wheel.radius;
}

/// Mean part of its energy that a wheel loses in each of some steps.
double lost_in_a_step(const Wheel& wheel, double tau, int steps, double dt)
{
    return 1 - std::pow(rolled(wheel, tau, steps, dt) / wheel.body.spin, 2.0 / steps);
}

}  // namespace

TEST_CASE("lever: by hand, at the start, in the middle and at the end of a quarter turn")
{
    given("a vertex at (2, 0) m, a turn of 90 degrees, tau 0");
    expect("lever", lever_at({2, 0}, pi / 2, 0), Vector2d(2, 0), 1e-15, "m");
    given("the same, tau 1/2");
    expect("lever", lever_at({2, 0}, pi / 2, 0.5), Vector2d(1, 1), 1e-15, "m");
    given("the same, tau 1");
    expect("lever", lever_at({2, 0}, pi / 2, 1), Vector2d(0, 2), 1e-15, "m");
}

TEST_CASE("lever: the work of an impulse is what it turns with the lever of the middle, whatever the turn")
{
    for (int trial = 0; trial < 100; ++trial) {
        const Vector2d vertex = random_vector();
        const double turn = 3 * random_number();
        const Vector2d displacement = lever_at(vertex, turn, 1) - lever_at(vertex, turn, 0);
        given("a vertex at ", readable(vertex), " m, a turn of ", turn, " rad");
        expect("displacement along x, from what a unit impulse turns", displacement.x(),
               2 * std::tan(turn / 2) * turning(lever_at(vertex, turn, 0.5), Vector2d(1, 0)), 1e-12, "m");
        expect("the same along y", displacement.y(),
               2 * std::tan(turn / 2) * turning(lever_at(vertex, turn, 0.5), Vector2d(0, 1)), 1e-12, "m");
    }
}

TEST_CASE("turn: no impulse leaves the spin, and levers of the start are known at once")
{
    const PlaneBody body{1, 0.5, 3};
    given("inertia 0.5 kg m^2, spin 3 rad/s, no impulse, dt 0.1 s");
    expect("turn", turn_found(body, {}, 1, 0.1), 0.3, 1e-15, "rad");
    given("the same, 2 N s upwards at (1, 0) m and 1 N s to the right at (0, 1) m, tau 0");
    expect("turn", turn_found(body, {{{1, 0}, {0, 2}}, {{0, 1}, {1, 0}}}, 0, 0.1), 0.5, 1e-14, "rad");
}

TEST_CASE("turn: by hand, a push on a vertex that ends 60 degrees further")
{
    const double spin = 10 * (pi / 3 - 0.2);
    given("inertia 1 kg m^2, a vertex at (1, 0) m gets 4 N s upwards, dt 0.1 s, tau 1, spin ", spin,
          " rad/s");
    expect("turn", turn_found({1, 1, spin}, {{{1, 0}, {0, 4}}}, 1, 0.1), pi / 3, 1e-12, "rad");
}

TEST_CASE("turn: it is the one that its own levers make, however many vertices are pushed")
{
    for (int trial = 0; trial < 200; ++trial) {
        PlaneBody body{1, std::pow(10, random_number()), 10 * random_number()};
        const double dt = 0.01 * std::pow(10, random_number()), tau = generator.number(0, 1);
        std::vector<VertexPush> pushes;
        double most = 0;
        for (int count = generator.whole(1, 6); count > 0; --count) {
            const Vector2d vertex = random_vector();
            pushes.push_back({vertex, random_vector()});
            most += vertex.norm() * pushes.back().impulse.norm();
        }
        const double scale = 0.8 * body.inertia / (dt * most);
        for (VertexPush& push : pushes)
            push.impulse *= scale;
        const double turn = turn_found(body, pushes, tau, dt);
        double made = dt * body.spin;
        for (const VertexPush& push : pushes)
            made += dt * moment(lever_of(push.vertex, turn, tau), push.impulse) / body.inertia;
        given(pushes.size(), " vertices, inertia ", body.inertia, " kg m^2, spin ", body.spin, " rad/s, dt ",
              dt, " s, tau ", tau);
        expect("turn", turn, made, 1e-12, "rad");
    }
}

TEST_CASE("lowest: it is under the centre at the end, and stood ahead of it at the start")
{
    const Wheel wheel = disk(0);
    given("a wheel of 0.1 m rolls to the right, a turn of -90 degrees in the step, tau 0");
    expect("lever", lever_of_the_lowest(wheel, -pi / 2, 0), Vector2d(0.1, 0), 1e-15, "m");
    given("the same, tau 1/2");
    expect("lever", lever_of_the_lowest(wheel, -pi / 2, 0.5), Vector2d(0.05, -0.05), 1e-15, "m");
    given("the same, tau 1");
    expect("lever", lever_of_the_lowest(wheel, -pi / 2, 1), Vector2d(0, -0.1), 1e-15, "m");
}

TEST_CASE("wheel: with the lever of the end a push from below turns nothing, and friction has the radius")
{
    for (const double up : {0.0, 1.0, 5.0}) {
        const Wheel wheel = disk(-20);
        given("a disk of 2 kg and 0.1 m, spin -20 rad/s, impulse (-0.5, ", up, ") N s, dt 1/60 s, tau 1");
        expect("turn", wheel_turn(wheel, {-0.5, up}, 1, 1.0 / 60), (-20 - 0.5 * 0.1 / 0.01) / 60, 1e-14,
               "rad");
    }
}

TEST_CASE("wheel: with an earlier lever a push from below brakes, with that of the start twice as much")
{
    const Wheel wheel = disk(-20);
    const double dt = 1.0 / 240, free = -20 * dt;
    const Vector2d push(0, 0.02);
    const double start = wheel_turn(wheel, push, 0, dt) - free,
                 middle = wheel_turn(wheel, push, 0.5, dt) - free;
    given("a disk of 2 kg and 0.1 m, spin -20 rad/s, impulse (0, 0.02) N s, dt 1/240 s");
    expect("what the start's lever takes of the turn", start, dt * 0.02 * 0.1 * std::sin(20 * dt) / 0.01,
           1e-6, "rad");
    expect("what the middle's takes, over that", middle / start, 0.5, 1e-3);
}

TEST_CASE("wheel: the floor pushes the point that is lowest at the end of the turn that was found")
{
    for (int trial = 0; trial < 200; ++trial) {
        const Wheel wheel = disk(60 * random_number(), std::pow(10, random_number()));
        const double dt = 0.01 * std::pow(10, random_number()), tau = generator.number(0, 1);
        Vector2d impulse = random_vector();
        impulse *= generator.number(0, 0.8) * wheel.body.inertia / (dt * wheel.radius * impulse.norm());
        const double turn = wheel_turn(wheel, impulse, tau, dt);
        const Complex at_start = Complex(0, -wheel.radius) * std::polar(1.0, -turn);
        const double made = moment(lever_of({at_start.real(), at_start.imag()}, turn, tau), impulse);
        given("a disk of ", wheel.body.mass, " kg and 0.1 m, spin ", wheel.body.spin, " rad/s, impulse ",
              readable(impulse), " N s, dt ", dt, " s, tau ", tau);
        expect("turn", turn, dt * (wheel.body.spin + made / wheel.body.inertia), 1e-12, "rad");
    }
}

TEST_CASE("rolling: with the lever of the end it never ends, to either side")
{
    for (const double spin : {-20.0, 5.0}) {
        given("a disk of 2 kg and 0.1 m, spin ", spin, " rad/s, 600 steps of 1/60 s, tau 1");
        expect("spin", rolled(disk(spin), 1, 600, 1.0 / 60), spin, 1e-9, "rad/s");
    }
}

TEST_CASE(
    "rolling: levers of start and middle take m g R (w dt)^2 and half of this from the energy in a step")
{
    for (const double tau : {0.0, 0.5})
        for (const double spin : {-20.0, 2.0})
            for (const double mass : {2.0, 50.0}) {
                const Wheel wheel = disk(spin, mass);
                const double dt = 1.0 / 500, turn = spin * dt,
                             energy = rolling_inertia(wheel) * spin * spin / 2;
                given("a disk of ", mass, " kg and 0.1 m, spin ", spin, " rad/s, 1 step of 1/500 s, tau ",
                      tau);
                expect("energy that is lost, over m g R (w dt)^2",
                       lost_in_a_step(wheel, tau, 1, dt) * energy /
                           (mass * gravity * wheel.radius * turn * turn),
                       1 - tau, 2e-3);
            }
}

TEST_CASE("rolling: a wheel slows down by the same part in each step, a ring by less than a disk")
{
    const Wheel ring{{2, 0.02, -20}, 0.1};
    const double dt = 1.0 / 500;
    given("2 kg, 0.1 m, spin -20 rad/s, steps of 1/500 s, tau 0");
    expect("part lost in each of 500 steps, over that in the first",
           lost_in_a_step(disk(-20), 0, 500, dt) / lost_in_a_step(disk(-20), 0, 1, dt), 1, 2e-3);
    expect("part that a ring loses, over that of a disk",
           lost_in_a_step(ring, 0, 1, dt) / lost_in_a_step(disk(-20), 0, 1, dt), 0.75, 1e-3);
}

TEST_CASE("measurement: what a rolling disk keeps of its spin, and what you predicted")
{
    const Wheel wheel = disk(-20);
    const double dt = 1.0 / 240;
    for (const auto& [moment_of_step, tau] :
         {std::pair{"start", 0.0}, std::pair{"middle", 0.5}, std::pair{"end", 1.0}}) {
        const double spin = rolled(wheel, tau, 1200, dt);
        given("a disk of 2 kg and 0.1 m, spin -20 rad/s, 1200 steps of 1/240 s, tau ", tau);
        expect("part of the energy that is lost in a step", 1 - std::pow(spin / -20, 2.0 / 1200),
               2 * (1 - tau) * gravity * 0.1 * 2 * dt * dt / rolling_inertia(wheel), 2e-5);
        say("levers of the ", moment_of_step, ": after 5 s ", spin / -20, " of the spin, by your prediction ",
            std::pow(1 - predicted_loss(wheel, tau, dt), 600));
    }
}
