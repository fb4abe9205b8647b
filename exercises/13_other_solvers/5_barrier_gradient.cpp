#include "exercises/13_other_solvers/5_barrier_gradient.hpp"
#include "exercises/not_implemented_yet.hpp"

namespace enduring {

double barrier(double distance, double d_hat) { not_implemented_yet("13.5"); }

double barrier_slope(double distance, double d_hat) { not_implemented_yet("13.5"); }

double rest_distance(double load, double kappa, double d_hat) { not_implemented_yet("13.5"); }

double free_part(double distance, double change) { not_implemented_yet("13.5"); }

double step_end(const BlockOverFloor& block, double kappa, double d_hat, double dt)
{
    not_implemented_yet("13.5");
}

}  // namespace enduring
