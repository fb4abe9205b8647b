// The motion as the faster one of two, and the factor from two rounds, as a secant has it.
#include "exercises/07_implicit_contact/6_rounds_run_away.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

WedgeMotion at_speed(const Wedge& wedge, double speed, double limit)
{
    const double impulse = wedge.stiffness * wedge.dt * wedge.dt * speed;
    return {speed, impulse * std::sin(wedge.angle), std::min(limit, impulse * std::cos(wedge.angle))};
}

}  // namespace

WedgeMotion solved_with(const Wedge& wedge, double limit)
{
    // The smaller impulse of friction counts, so the larger speed does.
    const double s = std::sin(wedge.angle), c = std::cos(wedge.angle);
    const double h = wedge.stiffness * wedge.dt * wedge.dt / wedge.mass;
    const double holds = wedge.free_speed / (1 + 2 * h),
                 slips = (wedge.free_speed - 2 * c * limit / wedge.mass) / (1 + 2 * h * s * s);
    return at_speed(wedge, std::max(holds, slips), limit);
}

int rounds_needed(const Wedge& wedge, double part, double tolerance, int most)
{
    double limit = 0, wanted = wedge.mu * solved_with(wedge, limit).normal;
    int rounds = 1;
    while (std::abs(wanted - limit) > tolerance && rounds <= most) {
        limit = (1 - part) * limit + part * wanted;
        wanted = wedge.mu * solved_with(wedge, limit).normal;
        ++rounds;
    }
    return rounds > most ? 0 : rounds;
}

double factor_of_a_round(const Wedge& wedge)
{
    const double held = wedge.mass * wedge.free_speed /
                        (wedge.mass + 2 * wedge.stiffness * wedge.dt * wedge.dt);
    const double limit = 0.5 * at_speed(wedge, held, INFINITY).friction;
    return wedge.mu * (solved_with(wedge, limit).normal - solved_with(wedge, 0).normal) / limit;
}

double best_part(const Wedge& wedge)
{
    const double factor = factor_of_a_round(wedge);
    return 1 / (1 - factor);
}

double predicted_mu(double angle) { return std::sin(angle) / std::cos(angle); }

}  // namespace enduring
