#include "exercises/12_joints/4_motor_that_stops.hpp"

#include <cmath>

namespace enduring {

/// The root in the form that loses no digits where little is left: 2 c / (b + sqrt(b^2 + 4 c)).
double wanted_speed(const Servo& servo, double left, double dt)
{
    if (left < 0)
        return -wanted_speed(servo, -left, dt);
    const double a = servo.braking * servo.most / servo.inertia;
    const double speed = 2 * left / (dt + std::sqrt(dt * dt + 2 * left / a));
    return speed < servo.fastest ? speed : servo.fastest;
}

double torque_of_step(const Servo& servo, double left, double speed, double load, double dt)
{
    const double missing = wanted_speed(servo, left, dt) - (speed + dt * load / servo.inertia);
    const double torque = missing * servo.inertia / dt;
    if (torque > servo.most)
        return servo.most;
    return torque < -servo.most ? -servo.most : torque;
}

Arrival turn_by(const Servo& servo, double way, double load, double dt)
{
    Arrival arrival;
    double left = way, speed = 0;
    for (long step = 1; step <= std::lround(10 / dt); ++step) {
        const double torque = torque_of_step(servo, left, speed, load, dt) + load;
        speed += torque / servo.inertia * dt;
        left -= speed * dt;
        if (way - left > arrival.farthest)
            arrival.farthest = way - left;
        if (std::abs(left) > way / 1000)
            arrival.time = static_cast<double>(step) * dt;
    }
    return arrival;
}

}  // namespace enduring
