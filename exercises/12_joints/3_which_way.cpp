#include "exercises/12_joints/3_which_way.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <cmath>

namespace enduring {

Swing step_by_start(const Swing& swing, double gravity, double dt)
{
    not_implemented_yet("12.3");
}

Swing step_by_end(const Swing& swing, double gravity, double dt)
{
    not_implemented_yet("12.3");
}

double energy(const Swing& swing, double gravity, double dt)
{
    not_implemented_yet("12.3");
}

EnergyLeft predicted(double omega, double dt)
{
    not_implemented_yet("12.3");
}

}  // namespace enduring
