#pragma once

namespace enduring {

/// A soft contact as a velocity constraint. With these three numbers the change of its impulse is
/// -mass mass_scale (speed + bias_rate separation) - impulse_scale sum.
struct SoftNumbers {
    double bias_rate;      ///< [1/s]
    double mass_scale;     ///< [1]
    double impulse_scale;  ///< [1]
};

/// The speed after an implicit step of length h: the spring acts from the final position of the mass, and the
/// damper at its final speed.
/// @param hertz          frequency of the spring with this mass [1/s]; its stiffness is mass (2 pi hertz)^2
/// @param damping_ratio  of critical, which is 2 mass 2 pi hertz
/// @param separation     at the start [m], negative where the spring is pressed
/// @param speed          at the start [m/s]
double implicit_speed(double hertz, double damping_ratio, double h, double separation, double speed);

/// The three numbers, from the same step. They contain no mass.
SoftNumbers soft_numbers(double hertz, double damping_ratio, double h);

/// The change of a contact's impulse by these numbers [N s]. The sum of impulses must not pull.
/// @param sum  of the impulses of this contact so far [N s]
double change_of_impulse(const SoftNumbers& soft, double mass, double separation, double speed, double sum);

/// A mass that moves up and down above a floor at height 0.
struct FallingMass {
    double mass;      ///< [kg]
    double height;    ///< of its underside [m], negative inside
    double velocity;  ///< [m/s]
};

/// A step of length dt in equal substeps under gravity of 9.81 m/s^2. In each substep gravity acts, the row
/// is solved, the height moves, and the row is solved again, without its spring (`relax`). The impulse of the
/// row begins at 0 in each substep. The three numbers of a solve are
/// - above the floor, in both solves: 1 / h, 1 and 0. Only the speed goes that would take the mass below it;
/// - inside: those of soft_numbers in the first solve, and 0, 1 and 0 in the second.
/// @param substeps  1 or more; h = dt / substeps
FallingMass soft_step(FallingMass body, double hertz, double damping_ratio, double dt, int substeps);

/// The time in which a depth falls to a part of itself [s], if nothing else pushes and the damping is large:
/// the depth decreases at bias_rate.
/// @param part  above 0 and below 1
double time_to_part(const SoftNumbers& soft, double part);

}  // namespace enduring
