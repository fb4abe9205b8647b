#pragma once

#include "common/simulation/contact_parameters.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// A particle above the plane y = 0 that the ground pushes back with a penalty force.
struct ParticleProblem {
    double mass = 1;         ///< [kg]
    double stiffness = 100;  ///< k [N/m]
    double gravity = 9.81;   ///< g, downwards [m/s^2]
    PenaltyMethod method = PenaltyMethod::continuous;
    double dt = 0.01;  ///< length of a step [s]
};

struct ParticleState {
    double height = 0;    ///< x, negative inside the ground [m]
    double velocity = 0;  ///< upwards [m/s]
};

/// One step: predict under gravity, push, commit velocity and then position (thesis 3.3; 7.4 to 7.10).
ParticleState step(const ParticleState& state, const ParticleProblem& problem);

/// The state after `steps` steps.
ParticleState simulate(ParticleState state, const ParticleProblem& problem, int steps);

/// Where the particle comes to rest [m]: the height that a step with velocity 0 keeps.
///
/// Not -m g / k: the impulse is computed from a way that gravity has already bent down. See the page.
double resting_height(const ParticleProblem& problem);

/// Top of the parabola through the heights of a free flight [m], from any state on it.
double top_of_flight(const ParticleState& state, const ParticleProblem& problem);

/// "DPF" or "CPF".
const char* short_name(PenaltyMethod method);

}  // namespace enduring
