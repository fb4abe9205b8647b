#include "exercises/08_speculative_contacts/1_margin.hpp"

#include <cmath>

namespace enduring {

double predicted_millimetres() { return 1; }

double fall_from_rest(double gravity, double dt, int steps)
{
    double height = 0, velocity = 0;
    for (int step = 0; step < steps; ++step) {
        velocity += gravity * dt;
        height += velocity * dt;
    }
    return height;
}

double margin_of(double gravity, double dt, double smallest, double fall, double nearness)
{
    const double weightless = smallest * nearness;
    return gravity * dt * dt * fall > weightless ? gravity * dt * dt * fall : weightless;
}

Approach after_a_step(const Approach& approach, double gravity, double dt)
{
    return {approach.gap - approach.speed * dt - gravity * dt * dt, approach.speed + gravity * dt};
}

Found find_pair(const Approach& approach, double gravity, double dt, double margin)
{
    if (approach.gap <= margin)
        return Found::near_start;
    const double end = after_a_step(approach, gravity, dt).gap;
    return end < 0 ? Found::crossing : Found::not_at_all;
}

double depth_when_found(Approach approach, double gravity, double dt, double margin)
{
    for (int step = 0;; ++step) {
        const double gap = approach.gap - step * approach.speed * dt - fall_from_rest(gravity, dt, step);
        if (gap <= margin)
            return gap < 0 ? -gap : 0;
    }
}

}  // namespace enduring
