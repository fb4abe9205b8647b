#include "common/simulation/make_joint.hpp"

#include "common/simulation/rigid_body.hpp"
#include "common/simulation/step.hpp"

#include <Eigen/Geometry>

#include <utility>

namespace enduring {

Mat3 axes_about(const Vec3& third)
{
    Mat3 axes;
    axes.col(2) = third;
    axes.col(0) = third.unitOrthogonal();
    axes.col(1) = third.cross(axes.col(0));
    return axes;
}

JointEnd joint_end(const World& world, int body, const Vec3& point, const Mat3& axes)
{
    const auto* const rigid =
        body < 0 ? nullptr
                 : dynamic_cast<const RigidBody*>(world.bodies[static_cast<std::size_t>(body)].get());
    const Pose pose = rigid ? rigid->motion().pose() : Pose{};
    return {body, pose.to_body(point), pose.orientation.conjugate() * Quaternion(axes)};
}

Joint make_joint(const World& world, std::string name, JointKind kind, int a, int b, const Vec3& at,
                 const Mat3& axes)
{
    Joint joint;
    joint.name = std::move(name);
    joint.kind = kind;
    joint.a = joint_end(world, a, at, axes);
    joint.b = joint_end(world, b, at, axes);
    return joint;
}

Joint make_rod(const World& world, std::string name, int a, int b, const Vec3& at, const Vec3& to)
{
    Joint joint = make_joint(world, std::move(name), JointKind::distance, a, b, at);
    joint.b = joint_end(world, b, to, Mat3::Identity());
    joint.way.low = joint.way.high = (at - to).norm();
    return joint;
}

}  // namespace enduring
