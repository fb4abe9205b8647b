#include "exercises/13_other_solvers/5_barrier_gradient.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

double barrier(double distance, double d_hat)
{
    not_implemented_yet("13.5");
}

double barrier_slope(double distance, double d_hat)
{
    not_implemented_yet("13.5");
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
    not_implemented_yet("13.5");
}

double free_part(double distance, double change)
{
    not_implemented_yet("13.5");
}

double step_end(const BlockOverFloor& block, double kappa, double d_hat, double dt)
{
    not_implemented_yet("13.5");
}

}  // namespace enduring
