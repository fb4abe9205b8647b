#include "common/simulation/joint_swing.hpp"

#include "common/simulation/joint_body.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <map>

namespace enduring {
namespace {

/// How a force at a lever of a body resists its turns [N m]: it stands still while the lever turns.
Mat3 turning_stiffness(const Vec3& force, const Vec3& lever)
{
    const Mat3 both = force * lever.transpose();
    return force.dot(lever) * Mat3::Identity() - (both + both.transpose()) / 2;
}

/// Of a soft body's point, no less than the change of its velocity per impulse in any direction [1/kg]; 0 for
/// what is not soft.
double soft_response(const World& world, const JointEnd& end)
{
    double sum = 0;
    for (std::size_t i = 0; end.is_soft() && i < 3; ++i)
        if (const double weight = end.weights[static_cast<Eigen::Index>(i)]; weight > 0)
            sum += weight * body_at(world, end)->inverse_mass(end.vertices[i]).norm();
    return sum;
}

}  // namespace

//! [joint_swing]
double joint_swing(const World& world, double dt)
{
    struct Pulled {
        Mat3 stiffness = Mat3::Zero();
        int joints = 0;
    };
    std::map<const RigidBody*, Pulled> pulled;
    double fastest = 0;  // omega^2
    for (const Joint& joint : world.joints) {
        if (joint.broken || joint.force.isZero(0))
            continue;
        const JointPose pose = committed_pose(world, joint);
        const bool is_distance = joint.kind == JointKind::distance;
        double response = 0;
        const auto pull = [&](const JointEnd& at, const Vec3& point, const Vec3& force) {
            const RigidBody* const body = rigid_at(world, at);
            response += soft_response(world, at);
            if (!body)
                return;
            const Vec3 lever = point - body->motion().pose().position;
            Pulled& of = pulled[body];
            of.stiffness += turning_stiffness(force, lever);
            ++of.joints;
            response += 1 / body->mass();
        };
        pull(joint.a, pose.point_a, joint.force);
        pull(joint.b, is_distance ? pose.point_b : pose.point_a, -joint.force);
        if (is_distance)  // a string that is pulled sideways
            fastest = std::max(fastest, response * joint.force.norm() / (pose.point_a - pose.point_b).norm());
    }
    for (const auto& [body, of] : pulled)
        if (of.joints > 1)  // held at one point alone it swings as a pendulum, which steps follow
            fastest = std::max(
                fastest,
                Mat3(body->motion().inverse_inertia() * of.stiffness).eigenvalues().real().maxCoeff());
    return dt * dt * fastest;
}
//! [joint_swing]

}  // namespace enduring
