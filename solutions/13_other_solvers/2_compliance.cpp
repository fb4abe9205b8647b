#include "exercises/13_other_solvers/2_compliance.hpp"

namespace enduring {

double multiplier_change(double error, double multiplier, double response, double compliance, double dt)
{
    const double scaled = compliance / (dt * dt);
    return (-error - scaled * multiplier) / (response + scaled);
}

BlockOnFloor substep(const BlockOnFloor& block, double compliance, double dt, int iterations)
{
    const double falling = block.velocity - 9.81 * dt;
    double height = block.height + falling * dt;
    double multiplier = 0;
    const bool is_inside = height < 0;
    for (int i = 0; is_inside && i < iterations; ++i) {
        const double change = multiplier_change(height, multiplier, 1 / block.mass, compliance, dt);
        multiplier += change;
        height += change / block.mass;
    }
    return {block.mass, height, (height - block.height) / dt};
}

double implicit_velocity(const BlockOnFloor& block, double compliance, double dt)
{
    const double falling = block.velocity - 9.81 * dt;
    const double per_metre = dt / (compliance * block.mass);  // change of velocity by the spring [1/s]
    return (falling - per_metre * block.height) / (1 + per_metre * dt);
}

double rest_depth(double mass, double compliance) { return mass * 9.81 * compliance; }

double compliance_for(double mass, int contacts, double depth) { return depth * contacts / (mass * 9.81); }

}  // namespace enduring
