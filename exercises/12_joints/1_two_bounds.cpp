#include "exercises/12_joints/1_two_bounds.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>
#include <limits>

namespace enduring {

double impulse(const Line& line, double u)
{
    not_implemented_yet("12.1");
}

Line floor_line(double stiffness, double depth, double dt)
{
    not_implemented_yet("12.1");
}

Line rope_line(double stiffness, double slack, double dt)
{
    not_implemented_yet("12.1");
}

Line brake_line(double most, double hold, double dt)
{
    not_implemented_yet("12.1");
}

double velocity_after(double mass, double free_velocity, const std::vector<Line>& lines)
{
    not_implemented_yet("12.1");
}

}  // namespace enduring
