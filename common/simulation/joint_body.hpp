#pragma once

#include "common/simulation/joint.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// The rigid body that a joint holds at one end; null for the world, and for a body that stands.
inline const RigidBody* rigid_at(const World& world, const JointEnd& end)
{
    return end.body < 0
               ? nullptr
               : dynamic_cast<const RigidBody*>(world.bodies[static_cast<std::size_t>(end.body)].get());
}

}  // namespace enduring
