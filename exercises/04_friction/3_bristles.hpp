#pragma once

namespace enduring {

/// Dahl's friction along a line: the surfaces touch with bristles that bend before they slip.
struct Bristles {
    double stiffness;  ///< of the bent bristles [N/m], positive
    double limit;      ///< mu times the normal force [N], positive
};

/// What one step does.
struct BristleStep {
    double bend;     ///< of the bristles at the end of the step [m]
    double impulse;  ///< on the point that slides [N s]
};

/// One step at constant velocity, exactly: the bend z obeys  dz/dt = v - (stiffness |v| / limit) z,  and the
/// bristles push with the force -stiffness z.
///
/// @param bend      z at the start of the step [m]
/// @param velocity  v [m/s]
/// @param dt        length of the step [s], positive
BristleStep bend_bristles(const Bristles& bristles, double bend, double velocity, double dt);

/// The energy that is lost when a point is dragged to and fro at constant speed, once the bristles have
/// forgotten how they began: minus the work of friction over one cycle.
/// @param amplitude  half the way between the turning points [m]
/// @param speed      [m/s], positive
/// @param steps      in each half of the cycle
/// @return           energy [J]
double loss_per_cycle(const Bristles& bristles, double amplitude, double speed, int steps);

}  // namespace enduring
