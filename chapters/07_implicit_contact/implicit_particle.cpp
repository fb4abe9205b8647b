#include "chapters/07_implicit_contact/implicit_particle.hpp"

#include "chapters/07_implicit_contact/weighted_impulse.hpp"

#include <algorithm>

namespace enduring {
namespace {

//! [find_way]
/// The velocity w that is consistent with the impulse it causes: inertia (w - free_way) = I(w).
///
/// I falls with w and is convex, so the difference of both sides rises and is concave. From the free
/// velocity, at which the ground has not pushed yet, Newton's method climbs towards the solution and never
/// passes it. No guess and no damping are needed.
double find_way(double height, double free_way, double inertia, const ImplicitParticle& problem,
                int& newton_steps)
{
    const double k = problem.stiffness, dt = problem.dt;
    for (double way = free_way;; ++newton_steps) {
        const auto [impulse, slope] = weighted_impulse(height, height + dt * way, problem.centre, k, dt);
        const double next = way - (inertia * (way - free_way) - impulse) / (inertia - dt * slope);
        if (!(next > way))
            return way;  // converged, up to rounding
        way = next;
    }
}
//! [find_way]

}  // namespace

//! [step]
ParticleState step(const ParticleState& state, const ImplicitParticle& problem, int* newton_steps)
{
    const auto& [mass, k, gravity, centre, update, dt] = problem;
    const double free_velocity = state.velocity - gravity * dt;
    const bool by_mean = update == PositionUpdate::mean_velocity;
    // Only half of the velocity's change appears in the mean, so the equation contains 2m instead of m.
    const double free_way = by_mean ? 0.5 * (state.velocity + free_velocity) : free_velocity;
    int count = 0;
    const double way = find_way(state.height, free_way, by_mean ? 2 * mass : mass, problem, count);
    if (newton_steps != nullptr)
        *newton_steps = count;
    return {state.height + dt * way, by_mean ? 2 * way - state.velocity : way};
}
//! [step]

ParticleState simulate(ParticleState state, const ImplicitParticle& problem, int steps)
{
    for (int i = 0; i < steps; ++i)
        state = step(state, problem);
    return state;
}

double energy(const ParticleState& state, const ImplicitParticle& problem)
{
    const auto& [height, velocity] = state;
    const double depth = std::min(0.0, height);
    return 0.5 * problem.mass * velocity * velocity + problem.mass * problem.gravity * height +
           0.5 * problem.stiffness * depth * depth;
}

}  // namespace enduring
