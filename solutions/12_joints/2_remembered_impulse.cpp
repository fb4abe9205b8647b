#include "exercises/12_joints/2_remembered_impulse.hpp"

#include <cmath>

namespace enduring {

double place_after(const Held& body, double impulse)
{
    return body.place + body.dt * (body.velocity + (body.load * body.dt + impulse) / body.mass);
}

double next_impulse(const Held& body, double p)
{
    const double k_dt = body.h * body.mass / body.dt;
    return p - k_dt * place_after(body, p) / (1 + body.h);
}

std::vector<double> errors(const Held& body, double begin, int rounds)
{
    std::vector<double> left;
    double p = begin;
    for (int i = 0; i < rounds; ++i) {
        p = next_impulse(body, p);
        left.push_back(place_after(body, p));
    }
    return left;
}

int rounds_needed(const Held& body, double tolerance)
{
    double p = 0;
    int rounds = 0;
    while (std::abs(place_after(body, p)) > tolerance) {
        p = next_impulse(body, p);
        ++rounds;
    }
    return rounds;
}

}  // namespace enduring
