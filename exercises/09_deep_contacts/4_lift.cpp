#include "exercises/09_deep_contacts/4_lift.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

double predicted_seconds()
{
    not_implemented_yet("9.4");
}

double faded(double rest_offset, const Fade& fade, double dt)
{
    not_implemented_yet("9.4");
}

int steps_to_fade(double rest_offset, double left, const Fade& fade, double dt)
{
    not_implemented_yet("9.4");
}

double work_of_rising(const ParticleState& before, const ParticleState& after, double rise,
                      const ImplicitParticle& particle)
{
    not_implemented_yet("9.4");
}

LettingOut let_out(double depth, const ImplicitParticle& particle, const Fade& fade, int steps)
{
    not_implemented_yet("9.4");
}

}  // namespace enduring
