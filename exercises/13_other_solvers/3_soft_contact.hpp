#pragma once

namespace enduring {

/// A soft contact as a row of velocities: with these three numbers a change of impulse is
/// -mass mass_scale (speed + bias_rate separation) - impulse_scale sum.
struct SoftNumbers {
    double bias_rate;      ///< [1/s]
    double mass_scale;     ///< [1]
    double impulse_scale;  ///< [1]
};

/// The speed after a step of h that is implicit: the spring acts from where the mass ends, the damper at the
/// speed with which it ends.
/// @param hertz          frequency of the spring with this mass [1/s]; its stiffness is mass (2 pi hertz)^2
/// @param damping_ratio  of critical, which is 2 mass 2 pi hertz
/// @param separation     at the start [m], negative where the spring is pressed
/// @param speed          at the start [m/s]
double implicit_speed(double hertz, double damping_ratio, double h, double separation, double speed);

/// The three numbers, from the same step. No mass is in them.
SoftNumbers soft_numbers(double hertz, double damping_ratio, double h);

/// The change of a contact's impulse that these numbers ask for [N s]. The sum of impulses must not pull.
/// @param sum  of the impulses of this contact so far [N s]
double change_of_impulse(const SoftNumbers& soft, double mass, double separation, double speed, double sum);

/// How long a depth takes to fall to a part of itself, where nothing else pushes and the damping is large: it
/// goes by bias_rate [s].
/// @param part  above 0 and below 1
double time_to_part(const SoftNumbers& soft, double part);

}  // namespace enduring
