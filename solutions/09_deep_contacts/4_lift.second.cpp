#include "exercises/09_deep_contacts/4_lift.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {
double predicted_seconds() { return 2; }

// By how much it fades: a part of what is there, or a stride.
double faded(double rest_offset, const Fade& fade, double dt)
{
    return rest_offset + std::min((1 - fade.keep) * -rest_offset, fade.speed * dt);
}

// Halves an interval of steps: how much is left after n of them has a formula.
int steps_to_fade(double rest_offset, double left, const Fade& fade, double dt)
{
    const double stride = fade.speed * dt, bend = stride / (1 - fade.keep), deep = -rest_offset;
    const double strides = std::max(0.0, std::ceil((deep - bend) / stride));
    const auto to_go = [&](double steps) {
        return steps <= strides ? deep - steps * stride
                                : (deep - strides * stride) * std::pow(fade.keep, steps - strides);
    };
    int low = -1, high = 1;
    while (to_go(high) >= left)
        high *= 2;
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        (to_go(middle) >= left ? low : high) = middle;
    }
    return high;
}

double work_of_rising(const ParticleState& before, const ParticleState& after, double rise,
                      const ImplicitParticle& particle)
{
    const double force = particle.mass *
                         ((after.velocity - before.velocity) / particle.dt + particle.gravity);
    return force * rise;
}

LettingOut let_out(double depth, const ImplicitParticle& particle, const Fade& fade, int steps)
{
    double rest_offset = -depth, fastest = 0, work = 0;
    ParticleState state{-depth, 0};
    while (steps-- > 0) {
        const double rise = faded(rest_offset, fade, particle.dt) - rest_offset;
        ParticleState next = step({state.height - rest_offset, state.velocity - rise / particle.dt},
                                  particle);
        rest_offset += rise;
        next.height += rest_offset;
        next.velocity += rise / particle.dt;
        work += work_of_rising(state, next, rise, particle);
        state = next;
        if (state.velocity > fastest)
            fastest = state.velocity;
    }
    return {state, rest_offset, fastest, work};
}

}  // namespace enduring
