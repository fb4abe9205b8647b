#include "exercises/01_particle_plane/3_stiffness_for_a_step.hpp"

// A second way: no formula for the limit. The largest stiffness is searched,
// by the spectral radius of the chapter's matrix.
#include "chapters/01_particle_plane/amplification.hpp"
#include "chapters/01_particle_plane/particle.hpp"

#include <cmath>
#include <stdexcept>

namespace enduring {

static double largest_stable(PenaltyMethod method)
{
    double low = 0.1, high = 10;  // k for a mass of 1 kg and a step of 1 s
    while (high - low > 1e-14 * high) {
        const double middle = 0.5 * (low + high);
        (spectral_radius(amplification(method, 1, middle, 1)) < 1 ? low : high) = middle;
    }
    return low;
}

double stiffness_for_step(std::span<const double> masses, double dt, PenaltyMethod method, double safety)
{
    if (masses.empty() || !(dt > 0) || !(safety > 0) || safety > 1)
        throw std::invalid_argument("particles, a positive dt and a safety in (0, 1] are needed");
    double lightest = masses[0];
    for (const double mass : masses) {
        if (!(mass > 0))
            throw std::invalid_argument("masses have to be positive");
        lightest = std::fmin(lightest, mass);
    }
    return safety * largest_stable(method) * lightest / (dt * dt);
}

double depth_at_rest(double dt, PenaltyMethod method, double safety, double gravity)
{
    ParticleProblem problem;
    problem.gravity = gravity;
    problem.method = method;
    problem.dt = dt;
    const double masses[] = {problem.mass};
    problem.stiffness = stiffness_for_step(masses, dt, method, safety);
    return -resting_height(problem);
}

double step_for_depth(double depth, double safety, double gravity)
{
    double low = 1e-9, high = 1e3;
    while (high / low > 1 + 1e-14) {
        const double middle = std::sqrt(low * high);
        (depth_at_rest(middle, PenaltyMethod::continuous, safety, gravity) < depth ? low : high) = middle;
    }
    return low;
}

}  // namespace enduring
