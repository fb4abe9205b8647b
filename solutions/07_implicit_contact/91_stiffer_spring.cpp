#include "exercises/07_implicit_contact/91_stiffer_spring.hpp"

#include <algorithm>

namespace enduring {

double asked_stiffness(const Pair& pair, double dt)
{
    const double by_mass = 100 * pair.mass / (dt * dt);
    const double by_load = pair.load / pair.wanted;
    return std::min(std::max(by_mass, by_load), 1e5 * by_mass);
}

double energy(const Spring& spring, double depth)
{
    const double pressed = std::min(0.0, depth - spring.rest);
    return 0.5 * spring.k * pressed * pressed;
}

Spring with_stiffness(const Spring& spring, double k, double depth)
{
    const double pressed = std::min(0.0, depth - spring.rest);
    if (pressed == 0)
        return {k, spring.rest};
    return {k, depth - spring.k / k * pressed};
}

Spring adapted(const Spring& spring, const Pair& pair, double depth, double dt)
{
    const double asked = asked_stiffness(pair, dt);
    if (asked > spring.k || spring.k > 2 * asked)
        return with_stiffness(spring, asked, depth);
    return spring;
}

double faded(double rest, double fastest, double dt)
{
    if (rest >= 0)
        return rest;
    return std::min(0.9 * rest, rest + fastest * dt);
}

}  // namespace enduring
