#include "exercises/13_other_solvers/3_soft_contact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring {

double implicit_speed(double hertz, double damping_ratio, double h, double separation, double speed)
{
    const double omega = 2 * std::numbers::pi * hertz;
    const double stiffness = omega * omega, damping = 2 * damping_ratio * omega;  // of a mass of 1 kg
    return (speed - h * stiffness * separation) / (1 + h * damping + h * h * stiffness);
}

SoftNumbers soft_numbers(double hertz, double damping_ratio, double h)
{
    const double omega = 2 * std::numbers::pi * hertz;
    const double a1 = 2 * damping_ratio + h * omega;
    const double a2 = h * omega * a1;
    return {omega / a1, a2 / (1 + a2), 1 / (1 + a2)};
}

double change_of_impulse(const SoftNumbers& soft, double mass, double separation, double speed, double sum)
{
    const double change = -mass * soft.mass_scale * (speed + soft.bias_rate * separation) -
                          soft.impulse_scale * sum;
    return std::max(change, -sum);
}

FallingMass soft_step(FallingMass body, double hertz, double damping_ratio, double dt, int substeps)
{
    const double h = dt / substeps;
    const SoftNumbers soft = soft_numbers(hertz, damping_ratio, h), rigid{1 / h, 1, 0}, relax{0, 1, 0};
    for (int i = 0; i < substeps; ++i) {
        double sum = 0;
        const auto solve = [&](const SoftNumbers& row) {
            const double change = change_of_impulse(row, body.mass, body.height, body.velocity, sum);
            sum += change;
            body.velocity += change / body.mass;
        };
        body.velocity -= 9.81 * h;
        solve(body.height > 0 ? rigid : soft);
        body.height += h * body.velocity;
        solve(body.height > 0 ? rigid : relax);
    }
    return body;
}

double time_to_part(const SoftNumbers& soft, double part) { return -std::log(part) / soft.bias_rate; }

}  // namespace enduring
