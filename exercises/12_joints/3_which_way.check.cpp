#include "exercises/12_joints/3_which_way.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <cmath>

using namespace enduring;

namespace {

/// At (1, 0), after a step that has turned the rod by this angle.
Swing on_chord(double angle, double dt)
{
    return {Vec2(1, 0), (Vec2(1, 0) - Vec2(std::cos(angle), -std::sin(angle))) / dt};
}

Swing random_swing(RandomInputs& random)
{
    const double angle = 3 * random.normal();
    return {Vec2(std::cos(angle), std::sin(angle)), Vec2(random.normal(), random.normal())};
}

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

TEST_CASE("steps: both leave the rod at its length, and the place follows from the velocity")
{
    RandomInputs random(1);
    for (int run = 0; run < 100; ++run) {
        const Swing swing = random_swing(random);
        given("run ", run, ", dt 0.02 s");
        for (const Swing& after : {step_by_start(swing, 9.81, 0.02), step_by_end(swing, 9.81, 0.02)}) {
            expect("length", after.place.norm(), 1, 1e-12, "m");
            expect("place less what the velocity brings",
                   (after.place - swing.place - 0.02 * after.velocity).norm(), 0, 1e-12, "m");
            expect_that("the shorter of two ways", (after.place - swing.place).norm() < 1);
        }
    }
}

TEST_CASE("directions: the impulse lies along the rod of the start, or along that of the end")
{
    RandomInputs random(2);
    for (int run = 0; run < 100; ++run) {
        const Swing swing = random_swing(random);
        const Vec2 free = swing.velocity + Vec2(0, -9.81 * 0.02);
        const Swing start = step_by_start(swing, 9.81, 0.02), end = step_by_end(swing, 9.81, 0.02);
        given("run ", run);
        expect("impulse beside the rod of the start", cross(start.velocity - free, swing.place), 0, 1e-11,
               "N s");
        expect("impulse beside the rod of the end", cross(end.velocity - free, end.place), 0, 1e-11, "N s");
    }
}

TEST_CASE("energy: a free fall keeps it, and a body at rest in the origin has none")
{
    given("gravity 10 m/s^2, dt 0.1 s");
    expect("in the origin", energy({Vec2(0, 0), Vec2(0, 0)}, 10, 0.1), 0, 1e-14, "J");
    Swing falls{Vec2(0.5, 0.3), Vec2(2, 3)};
    const double before = energy(falls, 10, 0.1);
    falls.velocity.y() -= 1;
    falls.place += 0.1 * falls.velocity;
    expect("after a step of a fall", energy(falls, 10, 0.1), before, 1e-13, "J");
    expect("of the speed alone", energy({Vec2(0, 0), Vec2(3, 0)}, 10, 0.1), 4.5, 1e-14, "J");
}

TEST_CASE("prediction: it is what one step of each kind leaves")
{
    for (const double angle : {0.01, 0.1, 0.5}) {
        const double dt = 0.05;
        const Swing swing = on_chord(angle, dt);
        const EnergyLeft left = predicted(angle / dt, dt);
        const double before = swing.velocity.squaredNorm();
        // chords by hand, not by the student's own steps
        const Vec2 last = swing.place - dt * swing.velocity, flown = 2 * swing.place - last;
        const Vec2 by_end = flown.normalized() - swing.place;
        given("omega dt = ", angle);
        expect("left by the start", left.by_start, 1, 1e-9, "");
        expect("left by the end", left.by_end, by_end.squaredNorm() / (dt * dt) / before, 1e-9, "");
    }
    Swing start = on_chord(0.03, 0.01), end = start;
    const double before = energy(start, 0, 0.01);
    for (int step = 0; step < 1000; ++step) {
        start = step_by_start(start, 0, 0.01);
        end = step_by_end(end, 0, 0.01);
    }
    say("after 10 s at 3 rad/s in steps of 10 ms the rod of the start leaves ",
        energy(start, 0, 0.01) / before, " of the energy, that of the end ", energy(end, 0, 0.01) / before);
}
