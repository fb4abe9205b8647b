#include "exercises/13_other_solvers/4_dual_update.hpp"

#include <cmath>

namespace enduring {

/// Both cases apart.
AugmentedContact dual_update(const AugmentedContact& contact, double error, double beta)
{
    AugmentedContact after = contact;
    after.multiplier += contact.stiffness * error;
    if (after.multiplier <= 0)
        after.multiplier = 0;
    else
        after.stiffness += beta * std::abs(error);
    return after;
}

/// From the free fall, by one Newton step: the potential is quadratic where it pushes.
double primal_update(const HeavyBlock& block, const AugmentedContact& contact, double dt)
{
    const double free_height = block.height + dt * block.velocity - 9.81 * dt * dt;
    const double push = contact.multiplier - contact.stiffness * free_height;
    if (push <= 0)
        return free_height;
    return free_height + push / (block.mass / (dt * dt) + contact.stiffness);
}

double step_height(const HeavyBlock& block, AugmentedContact& contact, double beta, double dt, int sweeps)
{
    if (sweeps == 0)
        return block.height;
    const double height = primal_update(block, contact, dt);
    contact = dual_update(contact, -height, beta);
    return sweeps == 1 ? height : step_height(block, contact, beta, dt, sweeps - 1);
}

/// Inertia over inertia and contact together.
double part_left(double mass, double stiffness, double dt)
{
    const double inertia = mass / (dt * dt);
    return inertia / (inertia + stiffness);
}

}  // namespace enduring
