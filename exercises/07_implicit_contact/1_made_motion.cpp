#include "chapters/07_implicit_contact/implicit_particle.hpp"

#include "chapters/07_implicit_contact/weighted_impulse.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>

namespace enduring {
namespace {

/// The velocity w that is consistent with the impulse it causes: inertia (w - free_way) = I(w).
///
/// I falls with w and is convex, so the difference of both sides rises and is concave. From the free
/// velocity, at which the ground has not pushed yet, Newton's method climbs towards the solution and never
/// passes it. No guess and no damping are needed.
double find_way(double height, double free_way, double inertia, const ImplicitParticle& problem,
                int& newton_steps)
{
    not_implemented_yet("7.1");
}

}  // namespace

ParticleState step(const ParticleState& state, const ImplicitParticle& problem, int* newton_steps)
{
    not_implemented_yet("7.1");
}

ParticleState simulate(ParticleState state, const ImplicitParticle& problem, int steps)
{
    for (int i = 0; i < steps; ++i)
        state = step(state, problem);
    return state;
}

double energy(const ParticleState& state, const ImplicitParticle& problem)
{
    not_implemented_yet("7.1");
}

}  // namespace enduring
