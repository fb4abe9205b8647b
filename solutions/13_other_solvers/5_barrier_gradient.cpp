#include "exercises/13_other_solvers/5_barrier_gradient.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

double barrier(double distance, double d_hat)
{
    if (distance >= d_hat)
        return 0;
    const double short_of = distance - d_hat;
    return -short_of * short_of * std::log(distance / d_hat);
}

double barrier_slope(double distance, double d_hat)
{
    if (distance >= d_hat)
        return 0;
    const double short_of = distance - d_hat;
    return -2 * short_of * std::log(distance / d_hat) - short_of * short_of / distance;
}

namespace {

double barrier_bend(double distance, double d_hat)
{
    if (distance >= d_hat)
        return 0;
    const double short_of = distance - d_hat;
    return -2 * std::log(distance / d_hat) - 4 * short_of / distance +
           short_of * short_of / (distance * distance);
}

}  // namespace

double rest_distance(double load, double kappa, double d_hat)
{
    double low = 0, high = d_hat;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        const bool pushes_more = -kappa * barrier_slope(middle, d_hat) > load;
        (pushes_more ? low : high) = middle;
    }
    return high;
}

double free_part(double distance, double change)
{
    if (distance + change > 0)
        return 1;
    return 0.8 * distance / -change;
}

double step_end(const BlockOverFloor& block, double kappa, double d_hat, double dt)
{
    const double inertia = block.mass / (dt * dt);
    const auto energy = [&](double x) {
        return 0.5 * inertia * (x - block.falls_to) * (x - block.falls_to) + kappa * barrier(x, d_hat);
    };
    double height = block.height;
    for (int step = 0; step < 200; ++step) {
        const double slope = inertia * (height - block.falls_to) + kappa * barrier_slope(height, d_hat);
        const double change = -slope / (inertia + kappa * barrier_bend(height, d_hat));
        double part = free_part(height, change);
        for (int i = 0; i < 60 && energy(height + part * change) > energy(height); ++i)
            part /= 2;
        height += part * change;
    }
    return height;
}

}  // namespace enduring
