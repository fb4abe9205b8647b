#include "exercises/01_particle_plane/4_what_a_bounce_costs.hpp"

#include "chapters/01_particle_plane/amplification.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <cmath>
#include <numbers>

namespace enduring {

double predicted_factor()
{
    not_implemented_yet("1.4");
}

double lost_by_a_bounce(const ParticleProblem& problem, double height)
{
    not_implemented_yet("1.4");
}

double measured_factor(ParticleProblem problem, double height)
{
    not_implemented_yet("1.4");
}

double law_of_loss(const ParticleProblem& problem)
{
    not_implemented_yet("1.4");
}

}  // namespace enduring
