#include "chapters/07_implicit_contact/implicit_particle.hpp"

#include "chapters/07_implicit_contact/weighted_impulse.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>

namespace enduring {

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
