#include "exercises/04_friction/3_bristles.hpp"

#include <cmath>

namespace enduring {

BristleStep bend_bristles(const Bristles& bristles, double bend, double velocity, double dt)
{
    const double rate = bristles.stiffness * std::abs(velocity) / bristles.limit;
    if (rate == 0)
        return {bend, -bristles.stiffness * bend * dt};
    // The bend falls from where it is to where it tends, like everything with a constant rate.
    const double full_bend = std::copysign(bristles.limit / bristles.stiffness, velocity);
    const double left = bend - full_bend;
    const double forgotten = -std::expm1(-rate * dt);
    return {bend - left * forgotten, -bristles.stiffness * (full_bend * dt + left * forgotten / rate)};
}

double loss_per_cycle(const Bristles& bristles, double amplitude, double speed, int steps)
{
    const double dt = 2 * amplitude / speed / steps;
    double bend = 0, loss = 0;
    for (int half = 0; half < 200; ++half) {
        const double velocity = half % 2 == 0 ? speed : -speed;
        if (half % 2 == 0)
            loss = 0;
        for (int i = 0; i < steps; ++i) {
            const BristleStep next = bend_bristles(bristles, bend, velocity, dt);
            bend = next.bend;
            loss -= next.impulse * velocity;
        }
    }
    return loss;
}

}  // namespace enduring
