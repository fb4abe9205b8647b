#include "exercises/13_other_solvers/2_compliance.hpp"

namespace enduring {

/// Numerator and denominator times dt^2.
double multiplier_change(double error, double multiplier, double response, double compliance, double dt)
{
    const double square = dt * dt;
    return -(square * error + compliance * multiplier) / (square * response + compliance);
}

/// For one contact the first correction is the implicit step of the spring, and the others change nothing.
BlockOnFloor substep(const BlockOnFloor& block, double compliance, double dt, int iterations)
{
    const double free_height = block.height + dt * block.velocity - 9.81 * dt * dt;
    if (free_height >= 0 || iterations == 0)
        return {block.mass, free_height, (free_height - block.height) / dt};
    const double left = compliance * block.mass / (dt * dt + compliance * block.mass);
    const double height = left * free_height;
    return {block.mass, height, (height - block.height) / dt};
}

/// All forces, over the mass and what the spring adds to it.
double implicit_velocity(const BlockOnFloor& block, double compliance, double dt)
{
    const double momentum = block.mass * block.velocity -
                            dt * (block.mass * 9.81 + block.height / compliance);
    return momentum / (block.mass + dt * dt / compliance);
}

double rest_depth(double mass, double compliance) { return compliance * (mass * 9.81); }

/// Each contact carries its part of the load.
double compliance_for(double mass, int contacts, double depth)
{
    const double load = mass * 9.81 / contacts;
    return depth / load;
}

}  // namespace enduring
