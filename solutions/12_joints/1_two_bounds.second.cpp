#include "exercises/12_joints/1_two_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace enduring {

double impulse(const Line& line, double u)
{
    const double free = -line.bias - line.slope * u;
    if (free < line.low)
        return line.low;
    return free > line.high ? line.high : free;
}

/// A floor is a rope of which the lift has come too low.
Line floor_line(double stiffness, double depth, double dt) { return rope_line(stiffness, -depth, dt); }

Line rope_line(double stiffness, double slack, double dt)
{
    Line line;
    line.bias = stiffness * slack * dt;
    line.slope = stiffness * dt * dt;
    line.high = std::numeric_limits<double>::infinity();
    return line;
}

Line brake_line(double most, double hold, double dt)
{
    Line line;
    line.slope = hold;
    line.high = most * dt;
    line.low = -line.high;
    return line;
}

/// The sum is made of straight pieces, so between the corners of all lines there is one that has the answer:
/// sort the corners and go through them.
double velocity_after(double mass, double free_velocity, const std::vector<Line>& lines)
{
    std::vector<double> corners;
    for (const Line& line : lines)
        for (const double bound : {line.low, line.high})
            if (std::isfinite(bound) && line.slope > 0)
                corners.push_back(-(bound + line.bias) / line.slope);
    std::sort(corners.begin(), corners.end());
    const auto missing = [&](double u) {
        double sum = mass * (u - free_velocity);
        for (const Line& line : lines)
            sum -= impulse(line, u);
        return sum;
    };
    std::size_t piece = 0;
    while (piece < corners.size() && missing(corners[piece]) < 0)
        ++piece;
    // a point inside the piece says which lines are at a bound
    double inside = free_velocity;
    if (!corners.empty())
        inside = piece == 0                ? corners.front() - 1
                 : piece == corners.size() ? corners.back() + 1
                                           : (corners[piece - 1] + corners[piece]) / 2;
    double slope = mass;
    for (const Line& line : lines) {
        const double free = -(line.bias + line.slope * inside);
        if (free > line.low && free < line.high)
            slope += line.slope;
    }
    return inside - missing(inside) / slope;
}

}  // namespace enduring
