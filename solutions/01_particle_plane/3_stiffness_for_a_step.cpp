#include "exercises/01_particle_plane/3_stiffness_for_a_step.hpp"

#include "chapters/01_particle_plane/amplification.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace enduring {

/// The largest h = k dt^2 / m that is stable, by the chapter's condition (1 + 2a) h < 4.
static double largest_h(PenaltyMethod method) { return 4 / (1 + 2 * look_ahead(method)); }

double stiffness_for_step(std::span<const double> masses, double dt, PenaltyMethod method, double safety)
{
    if (masses.empty())
        throw std::invalid_argument("there is no particle");
    if (!(dt > 0))
        throw std::invalid_argument("dt has to be positive");
    if (!(safety > 0 && safety <= 1))
        throw std::invalid_argument("safety has to lie in (0, 1]");
    if (!std::all_of(masses.begin(), masses.end(), [](double mass) { return mass > 0; }))
        throw std::invalid_argument("masses have to be positive");
    const double lightest = *std::min_element(masses.begin(), masses.end());
    return safety * largest_h(method) * lightest / (dt * dt);
}

double depth_at_rest(double dt, PenaltyMethod method, double safety, double gravity)
{
    const double h = safety * largest_h(method);
    const double fall = gravity * dt * dt;
    return fall / h - look_ahead(method) * fall;
}

double step_for_depth(double depth, double safety, double gravity)
{
    const double depth_over_fall = depth_at_rest(1, PenaltyMethod::continuous, safety, 1);
    return std::sqrt(depth / (gravity * depth_over_fall));
}

}  // namespace enduring
