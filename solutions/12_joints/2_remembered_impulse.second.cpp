#include "exercises/12_joints/2_remembered_impulse.hpp"

#include <cmath>

namespace enduring {
namespace {

/// The impulse that leaves no error: every round keeps 1 / (1 + h) of the distance to it.
double holding_impulse(const Held& body)
{
    return -body.mass * (body.place / body.dt + body.velocity) - body.load * body.dt;
}

}  // namespace

double place_after(const Held& body, double impulse)
{
    const double velocity = body.velocity + body.load * body.dt / body.mass + impulse / body.mass;
    return body.place + velocity * body.dt;
}

double next_impulse(const Held& body, double p)
{
    const double holds = holding_impulse(body);
    return holds + (p - holds) / (1 + body.h);
}

std::vector<double> errors(const Held& body, double begin, int rounds)
{
    std::vector<double> left(static_cast<std::size_t>(rounds));
    double error = place_after(body, begin);
    for (double& of_round : left)
        of_round = error /= 1 + body.h;
    return left;
}

int rounds_needed(const Held& body, double tolerance)
{
    int rounds = 0;
    for (double error = std::abs(place_after(body, 0)); error > tolerance; error /= 1 + body.h)
        ++rounds;
    return rounds;
}

}  // namespace enduring
