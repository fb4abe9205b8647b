#pragma once

#include <Eigen/Core>

namespace enduring {

using Vec2 = Eigen::Vector2d;

/// A point mass of 1 kg on a rod of 1 m that turns about the origin.
struct Swing {
    Vec2 place{1, 0};     ///< [m]
    Vec2 velocity{0, 0};  ///< [m/s]
};

/// One step. Gravity changes the velocity. Then the rod applies an impulse along its direction at the *start*
/// of the step, such that it has its length at the end. Then the mass moves with its new velocity.
/// @param gravity  downwards, along -y [m/s^2]
/// @param dt       [s]
Swing step_by_start(const Swing& swing, double gravity, double dt);

/// The same with an impulse along the direction of the rod at the *end* of the step.
Swing step_by_end(const Swing& swing, double gravity, double dt);

/// Kinetic and potential energy, with a correction for half a step of gravity, so that free fall conserves
/// the sum: v^2 / 2 + g y - dt / 2 g v_y [J].
double energy(const Swing& swing, double gravity, double dt);

/// Without gravity, a mass goes round and turns the rod by omega dt in each step, so its velocity is a chord
/// of the circle divided by dt. Which part of its energy is left after the next step of each kind?
/// @param omega  [rad/s], positive
struct EnergyLeft {
    double by_start, by_end;
};
EnergyLeft predicted(double omega, double dt);

}  // namespace enduring
