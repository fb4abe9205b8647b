#pragma once

#include "chapters/01_particle_plane/particle.hpp"

namespace enduring {

/// The velocity with which a step moves the particle: that of its end, as in
/// symplectic Euler, or the mean of both ends.
enum class PositionUpdate { end_velocity, mean_velocity };

/// Chapter 1's particle, pushed by the impulse of its actual path, not of the
/// path that it would take without the ground.
struct ImplicitParticle {
    double mass = 1;         ///< [kg]
    double stiffness = 100;  ///< k [N/m]
    double gravity = 9.81;   ///< g, downwards [m/s^2]
    double centre = 0.5;     ///< a, centre of the weight over the step: 1/2 is CPF, 1 DPF
    PositionUpdate update = PositionUpdate::end_velocity;
    double dt = 0.01;  ///< length of a step [s]
};

/// One step: finds the velocity that is consistent with the impulse it causes.
/// @param newton_steps  if given, receives how many Newton steps it took to find it
ParticleState step(const ParticleState& state, const ImplicitParticle& problem, int* newton_steps = nullptr);

/// The state after `steps` steps.
ParticleState simulate(ParticleState state, const ImplicitParticle& problem, int steps);

/// Kinetic, gravitational and elastic energy [J]; the last is that of the ground's spring, k depth^2 / 2.
double energy(const ParticleState& state, const ImplicitParticle& problem);

}  // namespace enduring
