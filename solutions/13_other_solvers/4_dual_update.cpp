#include "exercises/13_other_solvers/4_dual_update.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

AugmentedContact dual_update(const AugmentedContact& contact, double error, double beta)
{
    const double force = std::max(0.0, contact.multiplier + contact.stiffness * error);
    const double growth = force > 0 ? beta * std::abs(error) : 0;
    return {force, contact.stiffness + growth};
}

double primal_update(const HeavyBlock& block, const AugmentedContact& contact, double dt)
{
    const double falls_to = block.height + dt * (block.velocity - 9.81 * dt);
    const double inertia = block.mass / (dt * dt);
    const double height = (inertia * falls_to + contact.multiplier) / (inertia + contact.stiffness);
    const bool pushes = contact.multiplier - contact.stiffness * height > 0;
    return pushes ? height : falls_to;
}

double step_height(const HeavyBlock& block, AugmentedContact& contact, double beta, double dt, int sweeps)
{
    double height = block.height;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        height = primal_update(block, contact, dt);
        contact = dual_update(contact, -height, beta);
    }
    return height;
}

double part_left(double mass, double stiffness, double dt) { return 1 / (1 + stiffness * dt * dt / mass); }

}  // namespace enduring
