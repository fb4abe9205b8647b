#pragma once

#include "common/scenes/scene.hpp"

#include <span>

namespace enduring {

/// The stiffness at which the lightest of some particles, each alone on the
/// ground, uses a given part of what is stable.
///
/// @param masses  of the particles [kg], all positive, at least one
/// @param dt      length of the step [s], positive
/// @param method  discrete or continuous
/// @param safety  part of the largest stable k dt^2 / m, in (0, 1]
/// @return        k [N/m]
/// @throws std::invalid_argument  an argument outside its range
double stiffness_for_step(std::span<const double> masses, double dt, PenaltyMethod method, double safety);

/// How deep a particle rests below the plane with the stiffness that
/// stiffness_for_step gives it. Its mass drops out.
///
/// @param gravity  g [m/s^2]
/// @return         depth [m], positive below the plane, negative above it
double depth_at_rest(double dt, PenaltyMethod method, double safety, double gravity);

/// The step with which a particle rests at a given depth: the inverse
/// of depth_at_rest for the continuous method.
///
/// @param depth   wanted, below the plane [m], positive
/// @param safety  in (0, 1)
/// @return        dt [s]
double step_for_depth(double depth, double safety, double gravity);

}  // namespace enduring
