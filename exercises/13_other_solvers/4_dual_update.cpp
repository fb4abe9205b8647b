#include "exercises/13_other_solvers/4_dual_update.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

AugmentedContact dual_update(const AugmentedContact& contact, double error, double beta)
{
    not_implemented_yet("13.4");
}

double primal_update(const HeavyBlock& block, const AugmentedContact& contact, double dt)
{
    not_implemented_yet("13.4");
}

double step_height(const HeavyBlock& block, AugmentedContact& contact, double beta, double dt, int sweeps)
{
    not_implemented_yet("13.4");
}

double part_left(double mass, double stiffness, double dt)
{
    not_implemented_yet("13.4");
}

}  // namespace enduring
