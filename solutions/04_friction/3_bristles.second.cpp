// A second way: no exponential. Many small steps of the midpoint rule.
#include "exercises/04_friction/3_bristles.hpp"

#include <cmath>

namespace enduring {

BristleStep bend_bristles(const Bristles& bristles, double bend, double velocity, double dt)
{
    const auto slope = [&](double z) {
        return velocity - bristles.stiffness * std::abs(velocity) / bristles.limit * z;
    };
    const double rate = bristles.stiffness * std::abs(velocity) / bristles.limit;
    const int pieces = 1 + static_cast<int>(500 * std::fmin(rate * dt, 50));
    const double h = dt / pieces;
    double impulse = 0;
    for (int i = 0; i < pieces; ++i) {
        const double middle = bend + 0.5 * h * slope(bend), end = bend + h * slope(middle);
        impulse -= bristles.stiffness * h * (bend + 4 * middle + end) / 6;
        bend = end;
    }
    return {bend, impulse};
}

double loss_per_cycle(const Bristles& bristles, double amplitude, double speed, int steps)
{
    double bend = 0;
    const auto drag = [&](double velocity) {
        double work = 0;
        for (int i = 0; i < steps; ++i) {
            const BristleStep next = bend_bristles(bristles, bend, velocity, 2 * amplitude / speed / steps);
            bend = next.bend;
            work += next.impulse * velocity;
        }
        return work;
    };
    double work = 0;
    for (int cycle = 0; cycle < 100; ++cycle)
        work = drag(speed) + drag(-speed);
    return -work;
}

}  // namespace enduring
