#include "exercises/09_deep_contacts/4_lift.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

double predicted_seconds() { return 2; }

double faded(double rest_offset, const Fade& fade, double dt)
{
    return std::min(fade.keep * rest_offset, rest_offset + fade.speed * dt);
}

int steps_to_fade(double rest_offset, double left, const Fade& fade, double dt)
{
    const double stride = fade.speed * dt, bend = stride / (1 - fade.keep);
    double to_go = -rest_offset;
    int steps = 0;
    if (to_go > std::max(bend, left)) {
        steps = static_cast<int>(std::ceil((to_go - std::max(bend, left)) / stride));
        to_go -= steps * stride;
    }
    // What is left now, and still too much, becomes less by the factor `keep` in each step.
    if (to_go >= left)
        steps += static_cast<int>(std::floor(std::log(left / to_go) / std::log(fade.keep))) + 1;
    return steps;
}

double work_of_rising(const ParticleState& before, const ParticleState& after, double rise,
                      const ImplicitParticle& particle)
{
    const double impulse = particle.mass *
                           (after.velocity - before.velocity + particle.gravity * particle.dt);
    return impulse * rise / particle.dt;
}

LettingOut let_out(double depth, const ImplicitParticle& particle, const Fade& fade, int steps)
{
    LettingOut out{{-depth, 0}, -depth, 0, 0};
    for (int i = 0; i < steps; ++i) {
        const double rest_offset = faded(out.rest_offset, fade, particle.dt),
                     rise = rest_offset - out.rest_offset;
        const double speed = rise / particle.dt;
        const ParticleState seen = step({out.state.height - out.rest_offset, out.state.velocity - speed},
                                        particle);
        const ParticleState end{seen.height + rest_offset, seen.velocity + speed};
        out.work += work_of_rising(out.state, end, rise, particle);
        out.state = end;
        out.rest_offset = rest_offset;
        out.fastest = std::max(out.fastest, end.velocity);
    }
    return out;
}

}  // namespace enduring
