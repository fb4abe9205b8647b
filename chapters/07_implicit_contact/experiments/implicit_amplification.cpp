#include "chapters/07_implicit_contact/experiments/implicit_amplification.hpp"

#include <limits>

namespace enduring {

//! [amplification]
Eigen::Matrix2d amplification(const ImplicitParticle& problem)
{
    const auto& [mass, k, gravity, a, update, dt] = problem;
    const double h = k * dt * dt / mass;
    Eigen::Matrix2d matrix;
    if (update == PositionUpdate::end_velocity) {
        const double divisor = 1 + a * h;
        matrix << 1 - h / divisor, dt / divisor, -h / (dt * divisor), 1 / divisor;
    } else {
        const double divisor = 1 + a * h / 2;
        matrix << 1 - h / (2 * divisor), dt / divisor, -h / (dt * divisor), (1 - a * h / 2) / divisor;
    }
    return matrix;
}
//! [amplification]

double stable_below(double centre)
{
    return centre < 0.5 ? 4 / (1 - 2 * centre) : std::numeric_limits<double>::infinity();
}

double fastest_stiffness(double centre) { return 4 / ((1 - centre) * (1 - centre)); }

double fastest_factor(double centre) { return -(1 - centre) / (1 + centre); }

double ringing_factor(double centre) { return 1 - 1 / centre; }

}  // namespace enduring
