#pragma once

#include "chapters/01_particle_plane/particle.hpp"

namespace enduring {

/// Your prediction, written down before anything is measured: by which factor the
/// height that a bounce loses shrinks when the step is divided by 4 (from 0.04 ms to
/// 0.01 ms, continuous, k 100 000 N/m, 1 kg, from 1 m).
double predicted_factor();

/// The part of its height that the first bounce loses: 1 - (top after
/// the first contact) / (height of the drop).
///
/// @param problem  mass, stiffness, gravity, method and step
/// @param height   from which the particle is dropped, at velocity 0 [m]
double lost_by_a_bounce(const ParticleProblem& problem, double height);

/// The factor that was predicted, measured: the loss with a step over the loss with a quarter of it.
double measured_factor(ParticleProblem problem, double height);

/// The law: how much of its height half a swing loses to the step's own
/// damper c = a k dt, by the damped oscillator.
double law_of_loss(const ParticleProblem& problem);

}  // namespace enduring
