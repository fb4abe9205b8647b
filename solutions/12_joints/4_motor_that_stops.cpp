#include "exercises/12_joints/4_motor_that_stops.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

double wanted_speed(const Servo& servo, double left, double dt)
{
    const double brake = dt * servo.braking * servo.most / servo.inertia;  // change of speed in a step
    const double can_stop = std::sqrt(brake * brake + 2 * brake / dt * std::abs(left)) - brake;
    return std::copysign(std::min(can_stop, servo.fastest), left);
}

double torque_of_step(const Servo& servo, double left, double speed, double load, double dt)
{
    const double free = servo.inertia * (wanted_speed(servo, left, dt) - speed) / dt - load;
    return std::clamp(free, -servo.most, servo.most);
}

Arrival turn_by(const Servo& servo, double way, double load, double dt)
{
    Arrival arrival;
    double angle = 0, speed = 0;
    const long steps = std::lround(10 / dt);
    for (long step = 1; step <= steps; ++step) {
        speed += dt * (torque_of_step(servo, way - angle, speed, load, dt) + load) / servo.inertia;
        angle += dt * speed;
        arrival.farthest = std::max(arrival.farthest, angle);
        if (std::abs(way - angle) > 1e-3 * way)
            arrival.time = dt * static_cast<double>(step);
    }
    return arrival;
}

}  // namespace enduring
