#include "exercises/07_implicit_contact/6_rounds_run_away.hpp"

#include <cmath>

namespace enduring {

WedgeMotion solved_with(const Wedge& wedge, double limit)
{
    const double s = std::sin(wedge.angle), c = std::cos(wedge.angle);
    const double spring = wedge.stiffness * wedge.dt * wedge.dt;  // impulse over velocity
    const double momentum = wedge.mass * wedge.free_speed;
    const double held = momentum / (wedge.mass + 2 * spring);
    if (spring * c * held <= limit)
        return {held, spring * s * held, spring * c * held};
    const double speed = (momentum - 2 * c * limit) / (wedge.mass + 2 * spring * s * s);
    return {speed, spring * s * speed, limit};
}

int rounds_needed(const Wedge& wedge, double part, double tolerance, int most)
{
    double limit = 0;
    for (int round = 1; round <= most; ++round) {
        const double difference = wedge.mu * solved_with(wedge, limit).normal - limit;
        if (std::abs(difference) <= tolerance)
            return round;
        limit += part * difference;
    }
    return 0;
}

double factor_of_a_round(const Wedge& wedge)
{
    const double s = std::sin(wedge.angle), c = std::cos(wedge.angle);
    const double spring = wedge.stiffness * wedge.dt * wedge.dt;
    return -2 * wedge.mu * spring * s * c / (wedge.mass + 2 * spring * s * s);
}

double best_part(const Wedge& wedge) { return 1 / (1 - factor_of_a_round(wedge)); }

double predicted_mu(double angle) { return std::tan(angle); }

}  // namespace enduring
