#pragma once

#include "common/simulation/joint.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// The body that a joint holds at one end; null for the world.
inline const Body* body_at(const World& world, const JointEnd& end)
{
    return end.body < 0 ? nullptr : world.bodies[static_cast<std::size_t>(end.body)].get();
}

/// The same if it is a rigid body, else null.
inline const RigidBody* rigid_at(const World& world, const JointEnd& end)
{
    return dynamic_cast<const RigidBody*>(body_at(world, end));
}

/// Whether what it holds there answers forces: neither the world, nor what stands or moves as given.
inline bool answers_at(const World& world, const JointEnd& end)
{
    const Body* const body = body_at(world, end);
    return body && !body->is_static();
}

}  // namespace enduring
