#include "exercises/12_joints/4_motor_that_stops.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <cmath>

using namespace enduring;

TEST_CASE("speed: the wheel can just stop from where the step leaves it")
{
    RandomInputs random(4);
    for (int run = 0; run < 100; ++run) {
        const Servo servo{std::exp(random.normal()), std::exp(random.normal()), 0.5, 1e9};
        const double left = std::exp(random.normal()), dt = 0.02, a = 0.5 * servo.most / servo.inertia;
        const double v = wanted_speed(servo, left, dt);
        given("run ", run, ", ", left, " rad to go");
        expect("v^2 over 2 a (left - v dt)", v * v / (2 * a * (left - v * dt)), 1, 1e-9, "");
        expect_that("it goes on", v > 0);
    }
}

TEST_CASE("speed: near its target the wheel arrives in one step, on both sides, and it keeps to the fastest")
{
    const Servo servo{2, 3, 0.5, 4};
    given("2 kg m^2, 3 N m, half of it for braking, 4 rad/s at most, dt 0.01 s");
    expect("a billionth of a radian to go", wanted_speed(servo, 1e-9, 0.01), 1e-7, 1e-11, "rad/s");
    expect("backwards", wanted_speed(servo, -0.3, 0.01), -wanted_speed(servo, 0.3, 0.01), 1e-13, "rad/s");
    expect("at the target", wanted_speed(servo, 0, 0.01), 0, 0, "rad/s");
    expect("far away", wanted_speed(servo, 1e6, 0.01), 4, 0, "rad/s");
    expect("far away, backwards", wanted_speed(servo, -1e6, 0.01), -4, 0, "rad/s");
}

TEST_CASE("torque: it brings the wanted speed against a load, and is never more than the largest")
{
    RandomInputs random(6);
    for (int run = 0; run < 200; ++run) {
        const Servo servo{std::exp(random.normal()), std::exp(random.normal()), 0.5, 2};
        const double left = random.normal(), speed = random.normal(),
                     load = 0.3 * servo.most * random.normal(), dt = 0.05;
        const double torque = torque_of_step(servo, left, speed, load, dt);
        const double after = speed + dt * (torque + load) / servo.inertia,
                     wanted = wanted_speed(servo, left, dt);
        given("run ", run);
        expect_that("no more than the largest torque", std::abs(torque) <= servo.most * (1 + 1e-12));
        if (std::abs(torque) < servo.most * (1 - 1e-12))
            expect("speed after the step", after, wanted, 1e-9, "rad/s");
        else
            expect_that("all of the torque towards the wanted speed", torque * (wanted - after) >= -1e-12);
    }
}

TEST_CASE("way: the wheel arrives in the time of its torque, and no farther than its target")
{
    const Servo servo{1, 1, 0.5, 1e9};
    const Arrival arrival = turn_by(servo, 1.5, 0, 0.001);
    // up with 1 rad/s^2 to v, down with 1/2: v^2 / 2 (1 + 2) = 1.5, and the time is v (1 + 2)
    given("1 kg m^2, 1 N m, 1.5 rad to go");
    expect_that("the time of speeding up and braking, to the twentieth part",
                std::abs(arrival.time - 3) < 0.15);
    expect_that("not beyond the target", arrival.farthest <= 1.5 + 1e-9);
    const Servo slow{1, 1, 0.5, 0.1};
    expect_that("with 0.1 rad/s at most it takes 15 s for 1.5 rad, so 9 s for 0.9",
                std::abs(turn_by(slow, 0.9, 0, 0.001).time - 9) < 0.3);
}

TEST_CASE("load: half of the torque is left for it")
{
    const Servo careful{1, 1, 0.5, 1e9}, bold{1, 1, 1, 1e9};
    const double safe = turn_by(careful, 1.5, 0.49, 0.001).farthest,
                 far = turn_by(bold, 1.5, 0.49, 0.001).farthest;
    given("a load of 0.49 N m forwards, with 1 N m at most");
    expect_that("half of the torque stops in time", safe <= 1.5 + 1e-6);
    expect_that("all of the torque comes too late", far > 1.6);
    say("a wheel turns by 1.5 rad in ", turn_by(careful, 1.5, 0, 0.001).time,
        " s; with a load of half its torque and all of it for braking it comes to ", far, " rad");
}
