#include "chapters/01_particle_plane/particle.hpp"

#include "chapters/01_particle_plane/plane_impulse.hpp"

#include <cmath>

namespace enduring {

//! [step]
ParticleState step(const ParticleState& state, const ParticleProblem& problem)
{
    const auto& [mass, k, gravity, method, dt] = problem;
    const double predicted_velocity = state.velocity - gravity * dt;
    const double predicted_height = state.height + predicted_velocity * dt;

    const double impulse = method == PenaltyMethod::discrete
                               ? discrete_plane_impulse(predicted_height, k, dt)
                               : continuous_plane_impulse(state.height, predicted_height, k, dt);

    const double velocity = predicted_velocity + impulse / mass;
    return {state.height + velocity * dt, velocity};
}
//! [step]

ParticleState simulate(ParticleState state, const ParticleProblem& problem, int steps)
{
    for (int i = 0; i < steps; ++i)
        state = step(state, problem);
    return state;
}

//! [resting_height]
double resting_height(const ParticleProblem& problem)
{
    const auto& [mass, k, gravity, method, dt] = problem;
    const double fall = gravity * dt * dt;  // how far the prediction drops from rest
    const double static_height = -mass * gravity / k;
    if (method == PenaltyMethod::discrete)
        return static_height + fall;
    if (static_height + fall / 2 <= 0)
        return static_height + fall / 2;
    // it dips in only during the last part of the step
    return fall * (1 - std::sqrt(-2 * static_height / fall));
}
//! [resting_height]

double top_of_flight(const ParticleState& state, const ParticleProblem& problem)
{
    // Symplectic Euler's heights lie on a parabola whose velocity at the sample is v - g dt / 2.
    const double velocity = state.velocity - 0.5 * problem.gravity * problem.dt;
    return state.height + velocity * velocity / (2 * problem.gravity);
}

const char* short_name(PenaltyMethod method) { return method == PenaltyMethod::discrete ? "DPF" : "CPF"; }

}  // namespace enduring
