#pragma once

#include "common/scenes/scene.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// Steps of a scene in which nothing touches, without a solver.
inline void step(Scene& scene, int steps)
{
    Contacts contacts;
    for (int i = 0; i < steps; ++i)
        advance(scene.world, contacts, {}, scene.dt);
}

}  // namespace enduring
