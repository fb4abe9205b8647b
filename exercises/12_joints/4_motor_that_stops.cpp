#include "exercises/12_joints/4_motor_that_stops.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

double wanted_speed(const Servo& servo, double left, double dt)
{
    not_implemented_yet("12.4");
}

double torque_of_step(const Servo& servo, double left, double speed, double load, double dt)
{
    not_implemented_yet("12.4");
}

Arrival turn_by(const Servo& servo, double way, double load, double dt)
{
    not_implemented_yet("12.4");
}

}  // namespace enduring
