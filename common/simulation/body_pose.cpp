#include "common/simulation/body_pose.hpp"

#include "common/simulation/driven_body.hpp"
#include "common/simulation/rigid_body.hpp"

namespace enduring {

Pose committed_pose(const Body& body)
{
    if (const auto* const rigid = dynamic_cast<const RigidBody*>(&body))
        return rigid->motion().pose();
    const auto* const driven = dynamic_cast<const DrivenBody*>(&body);
    return driven ? driven->pose(driven->time()) : Pose{};
}

Pose predicted_pose(const Body& body, double dt)
{
    if (const auto* const rigid = dynamic_cast<const RigidBody*>(&body))
        return rigid->motion().predicted_pose(dt);
    const auto* const driven = dynamic_cast<const DrivenBody*>(&body);
    return driven ? driven->pose(driven->time() + dt) : Pose{};
}

}  // namespace enduring
