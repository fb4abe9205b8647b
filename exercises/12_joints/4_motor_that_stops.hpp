#pragma once

namespace enduring {

/// A motor that turns a wheel to an angle.
struct Servo {
    double inertia = 1;    ///< of the wheel [kg m^2]
    double most = 1;       ///< largest torque [N m]
    double braking = 0.5;  ///< part of it that the motor plans for braking
    double fastest = 1e9;  ///< [rad/s]
};

/// The speed that the wheel may have in a step, if the angle `left` [rad] is still to go: after a step with
/// this speed, the part `braking` of the torque can stop the wheel before the target. The speed has the sign
/// of `left`, and is at most `fastest`.
double wanted_speed(const Servo& servo, double left, double dt);

/// The torque of a step [N m]: it brings the wheel to the wanted speed under a load, as far as the largest
/// torque allows.
/// @param speed  at the start of the step [rad/s]
/// @param load   external torque on the wheel [N m]
double torque_of_step(const Servo& servo, double left, double speed, double load, double dt);

struct Arrival {
    double time = 0;      ///< until the wheel stays within a thousandth of `way` from the target [s]
    double farthest = 0;  ///< the largest angle reached [rad]
};

/// Turns a wheel from rest by `way` [rad]: in each step the torque and the load change the speed, and the new
/// speed changes the angle. The motion lasts ten seconds.
Arrival turn_by(const Servo& servo, double way, double load, double dt);

}  // namespace enduring
