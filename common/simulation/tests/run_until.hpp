#pragma once

#include "common/simulation/step.hpp"

namespace enduring {

/// Steps of dt, without pairs at first, to the one that ends nearest to a time [s].
inline void run_until(World& world, double time, double dt, const Solver& solver = {})
{
    Contacts contacts;
    while (world.time < time - dt / 2)
        advance(world, contacts, solver, dt);
}

}  // namespace enduring
