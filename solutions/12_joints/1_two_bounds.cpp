#include "exercises/12_joints/1_two_bounds.hpp"

#include <algorithm>
#include <limits>

namespace enduring {

double impulse(const Line& line, double u)
{
    return std::max(line.low, std::min(line.high, -(line.bias + line.slope * u)));
}

Line floor_line(double stiffness, double depth, double dt)
{
    return {-dt * stiffness * depth, stiffness * dt * dt, 0, std::numeric_limits<double>::infinity()};
}

Line rope_line(double stiffness, double slack, double dt)
{
    return {dt * stiffness * slack, stiffness * dt * dt, 0, std::numeric_limits<double>::infinity()};
}

Line brake_line(double most, double hold, double dt) { return {0, hold, -most * dt, most * dt}; }

double velocity_after(double mass, double free_velocity, const std::vector<Line>& lines)
{
    const auto missing = [&](double u) {
        double sum = mass * (u - free_velocity);
        for (const Line& line : lines)
            sum -= impulse(line, u);
        return sum;
    };
    double low = free_velocity - 1, high = free_velocity + 1;
    for (double size = 1; missing(low) > 0; size *= 2)
        low -= size;
    for (double size = 1; missing(high) < 0; size *= 2)
        high += size;
    for (int i = 0; i < 200; ++i) {
        const double middle = (low + high) / 2;
        if (missing(middle) > 0)
            high = middle;
        else
            low = middle;
    }
    return (low + high) / 2;
}

}  // namespace enduring
