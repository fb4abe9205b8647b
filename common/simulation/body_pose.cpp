#include "common/simulation/body_pose.hpp"

#include "common/simulation/driven_body.hpp"
#include "common/simulation/rigid_body.hpp"

#include <Eigen/Geometry>

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

Vec3 mean_turn_rate(const Pose& from, const Pose& to, double dt)
{
    const Eigen::AngleAxisd turn(to.orientation * from.orientation.conjugate());
    return turn.angle() / dt * turn.axis();
}

Vec3 mean_turn_rate(const Body& body, double dt)
{
    return mean_turn_rate(committed_pose(body), predicted_pose(body, dt), dt);
}

}  // namespace enduring
