#include "exercises/04_friction/3_bristles.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <cmath>

namespace enduring {

BristleStep bend_bristles(const Bristles& bristles, double bend, double velocity, double dt)
{
    not_implemented_yet("4.3");
}

double loss_per_cycle(const Bristles& bristles, double amplitude, double speed, int steps)
{
    not_implemented_yet("4.3");
}

}  // namespace enduring
