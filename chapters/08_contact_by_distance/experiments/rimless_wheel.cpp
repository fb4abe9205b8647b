#include "chapters/08_contact_by_distance/experiments/rimless_wheel.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter08 {
namespace {

constexpr double standard_gravity = 9.81, longest_step = 1e-4;

double inertia_about_edge(const RimlessWheel& wheel)
{
    return wheel.inertia + wheel.mass * wheel.radius * wheel.radius;
}

double acceleration_at(const RimlessWheel& wheel, double angle)
{
    return wheel.mass * standard_gravity * wheel.radius * std::sin(angle + wheel.slope) /
           inertia_about_edge(wheel);
}

}  // namespace

//! [kept]
double RimlessWheel::kept() const
{
    const double turn = 2 * std::numbers::pi / sides;
    return (inertia + mass * radius * radius * std::cos(turn)) / inertia_about_edge(*this);
}
//! [kept]

void RimlessWheel::roll(double time)
{
    const double half_side = std::numbers::pi / sides;
    const long steps = std::max(1L, std::lround(time / longest_step));
    const double dt = time / static_cast<double>(steps);
    for (long i = 0; i < steps; ++i) {  // the midpoint rule
        const double middle = angle + 0.5 * dt * rate;
        angle += dt * (rate + 0.5 * dt * acceleration_at(*this, angle));
        rate += dt * acceleration_at(*this, middle);
        if (angle > half_side) {
            angle -= 2 * half_side;
            rate *= kept();
        }
    }
}

double RimlessWheel::pressed() const
{
    const double upwards = -radius *
                           (acceleration_at(*this, angle) * std::sin(angle) + rate * rate * std::cos(angle));
    return mass * (standard_gravity * std::cos(slope) + upwards);
}

}  // namespace enduring::chapter08
