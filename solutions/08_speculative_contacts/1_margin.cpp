#include "exercises/08_speculative_contacts/1_margin.hpp"

#include <algorithm>

namespace enduring {

double predicted_millimetres() { return 1; }

double fall_from_rest(double gravity, double dt, int steps)
{
    const double of_one = gravity * dt * dt;
    return of_one * steps * (steps + 1) / 2;
}

double margin_of(double gravity, double dt, double smallest, double fall, double nearness)
{
    const double by_gravity = fall * fall_from_rest(gravity, dt, 1);
    const double by_size = nearness * smallest;
    return std::max(by_gravity, by_size);
}

Approach after_a_step(const Approach& approach, double gravity, double dt)
{
    const double speed = approach.speed + gravity * dt;
    return {approach.gap - speed * dt, speed};
}

Found find_pair(const Approach& approach, double gravity, double dt, double margin)
{
    const Approach end = after_a_step(approach, gravity, dt);
    if (approach.gap <= margin)
        return Found::near_start;
    if (end.gap < 0)
        return Found::crossing;
    return Found::not_at_all;
}

double depth_when_found(Approach approach, double gravity, double dt, double margin)
{
    while (approach.gap > margin)
        approach = after_a_step(approach, gravity, dt);
    return std::max(0.0, -approach.gap);
}

}  // namespace enduring
