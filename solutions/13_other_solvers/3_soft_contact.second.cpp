#include "exercises/13_other_solvers/3_soft_contact.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

const double pi = std::acos(-1.0);

/// What the step adds of spring and damper, h c + h^2 k of a mass of 1 kg.
double added(double hertz, double damping_ratio, double h)
{
    const double turn = 2 * pi * hertz * h;
    return 2 * damping_ratio * turn + turn * turn;
}

}  // namespace

double implicit_speed(double hertz, double damping_ratio, double h, double separation, double speed)
{
    const double turn = 2 * pi * hertz * h;
    return (speed - turn * turn * separation / h) / (1 + added(hertz, damping_ratio, h));
}

/// The bias is the part h k of what is added, and the rest says how much of an impulse stays.
SoftNumbers soft_numbers(double hertz, double damping_ratio, double h)
{
    const double all = added(hertz, damping_ratio, h), turn = 2 * pi * hertz * h;
    return {turn * turn / h / all, 1 - 1 / (1 + all), 1 / (1 + all)};
}

double change_of_impulse(const SoftNumbers& soft, double mass, double separation, double speed, double sum)
{
    const double wanted = sum * (1 - soft.impulse_scale) -
                          soft.mass_scale * mass * (speed + soft.bias_rate * separation);
    return (wanted > 0 ? wanted : 0) - sum;
}

namespace {

/// What change_of_impulse leaves of a speed, for a row without a spring, and the sum with it.
void solve_rigid(FallingMass& body, double bias, double& sum)
{
    const double wanted = std::max(0.0, sum - body.mass * (body.velocity + bias));
    body.velocity += (wanted - sum) / body.mass;
    sum = wanted;
}

}  // namespace

FallingMass soft_step(FallingMass body, double hertz, double damping_ratio, double dt, int substeps)
{
    const double h = dt / substeps;
    for (int left = substeps; left > 0; --left) {
        double sum = 0;
        body.velocity -= h * 9.81;
        if (body.height > 0) {
            solve_rigid(body, body.height / h, sum);
        } else {
            sum = change_of_impulse(soft_numbers(hertz, damping_ratio, h), body.mass, body.height,
                                    body.velocity, 0);
            body.velocity += sum / body.mass;
        }
        body.height += h * body.velocity;
        solve_rigid(body, std::max(0.0, body.height / h), sum);
    }
    return body;
}

double time_to_part(const SoftNumbers& soft, double part) { return std::log(1 / part) / soft.bias_rate; }

}  // namespace enduring
