#include "exercises/01_particle_plane/4_what_a_bounce_costs.hpp"

#include "chapters/01_particle_plane/amplification.hpp"

#include <cmath>
#include <numbers>

namespace enduring {

double predicted_factor() { return 4; }

double lost_by_a_bounce(const ParticleProblem& problem, double height)
{
    ParticleState state{height, 0};
    while (state.height > 0)
        state = step(state, problem);
    while (state.height <= 0)
        state = step(state, problem);
    const double top = top_of_flight(state, problem);
    return 1 - top / height;
}

double measured_factor(ParticleProblem problem, double height)
{
    const double lost = lost_by_a_bounce(problem, height);
    problem.dt /= 4;
    return lost / lost_by_a_bounce(problem, height);
}

double law_of_loss(const ParticleProblem& problem)
{
    const double damper = look_ahead(problem.method) * problem.stiffness * problem.dt;
    const double ratio = damper / (2 * std::sqrt(problem.stiffness * problem.mass));
    const double kept_speed = std::exp(-std::numbers::pi * ratio / std::sqrt(1 - ratio * ratio));
    return 1 - kept_speed * kept_speed;
}

}  // namespace enduring
