#include "exercises/13_other_solvers/5_barrier_gradient.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

/// By the part of d_hat that is left.
double barrier(double distance, double d_hat)
{
    const double part = std::min(1.0, distance / d_hat);
    return -d_hat * d_hat * (1 - part) * (1 - part) * std::log(part);
}

double barrier_slope(double distance, double d_hat)
{
    const double part = std::min(1.0, distance / d_hat);
    return d_hat * ((1 - part) * 2 * std::log(part) - (1 - part) * (1 - part) / part);
}

/// The derivative along x falls through zero once: halve.
double step_end(const BlockOverFloor& block, double kappa, double d_hat, double dt)
{
    const auto slope = [&](double x) {
        return block.mass / (dt * dt) * (x - block.falls_to) + kappa * barrier_slope(x, d_hat);
    };
    double low = 0, high = std::max(d_hat, block.falls_to);
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (slope(middle) < 0 ? low : high) = middle;
    }
    return high;
}

/// A load that does not move: the end of a very long step from where it pulls.
double rest_distance(double load, double kappa, double d_hat)
{
    const double mass = 1e-9, dt = 1;
    return step_end({mass, d_hat, d_hat - load / mass}, kappa, d_hat, dt);
}

double free_part(double distance, double change)
{
    return change <= -distance ? 0.8 * distance / std::abs(change) : 1;
}

}  // namespace enduring
