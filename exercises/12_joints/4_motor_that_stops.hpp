#pragma once

namespace enduring {

/// A motor that turns a wheel to an angle.
struct Servo {
    double inertia = 1;    ///< of the wheel [kg m^2]
    double most = 1;       ///< largest torque [N m]
    double braking = 0.5;  ///< part of it with which the motor counts on stopping
    double fastest = 1e9;  ///< [rad/s]
};

/// The speed with which the wheel may go on in a step, if `left` [rad] are still to go: so that behind the
/// step, at this speed, the part `braking` of the torque stops it before the target.  It has the sign of
/// `left`, and is no faster than `fastest`.
double wanted_speed(const Servo& servo, double left, double dt);

/// The torque of a step [N m]: it brings the wheel to the wanted speed, as far as the largest torque can,
/// against a load.
/// @param speed  with which the step begins [rad/s]
/// @param load   torque on the wheel from outside [N m]
double torque_of_step(const Servo& servo, double left, double speed, double load, double dt);

struct Arrival {
    double time = 0;      ///< until the wheel is within a thousandth of the way, and stays there [s]
    double farthest = 0;  ///< that it has come [rad]
};

/// Turns a wheel from rest by `way` [rad]: in each step the torque and the load change the speed, and the new
/// speed the angle. It looks for ten seconds.
Arrival turn_by(const Servo& servo, double way, double load, double dt);

}  // namespace enduring
