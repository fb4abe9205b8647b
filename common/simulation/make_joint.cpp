#include "common/simulation/make_joint.hpp"

#include "common/geometry/closest_points.hpp"
#include "common/simulation/body_pose.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/joint_body.hpp"

#include <Eigen/Geometry>

#include <limits>
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

bool is_soft(const World& world, int body)
{
    return body >= 0 &&
           dynamic_cast<const DeformableBody*>(world.bodies[static_cast<std::size_t>(body)].get()) != nullptr;
}

namespace {

/// The point of a soft body's surface that is nearest to a point.
JointEnd end_on_surface(const World& world, int body, const Vec3& point, const Mat3& axes)
{
    const Body& soft = *world.bodies[static_cast<std::size_t>(body)];
    JointEnd end{body, Vec3::Zero(), Quaternion(axes)};
    double nearest = std::numeric_limits<double>::infinity();
    for (const Face& face : soft.surface().faces()) {
        const auto corner = [&](std::size_t i) {
            return soft.positions_t0()[static_cast<std::size_t>(face[i])];
        };
        const ClosestOnTriangle closest = closest_on_triangle(point, corner(0), corner(1), corner(2));
        if (closest.distance >= nearest)
            continue;
        nearest = closest.distance;
        end.vertices = {face[0], face[1], face[2]};
        end.weights = Vec3(closest.weights[0], closest.weights[1], closest.weights[2]);
    }
    return end;
}

}  // namespace

JointEnd joint_end(const World& world, int body, const Vec3& point, const Mat3& axes)
{
    if (is_soft(world, body))
        return end_on_surface(world, body, point, axes);
    const Pose pose = body < 0 ? Pose{} : committed_pose(*world.bodies[static_cast<std::size_t>(body)]);
    return {body, pose.to_body(point), pose.orientation.conjugate() * Quaternion(axes)};
}

Vec3 held_point(const World& world, int body, const Vec3& point)
{
    if (!is_soft(world, body))
        return point;
    Joint joint;
    joint.a = joint_end(world, body, point, Mat3::Identity());
    return committed_pose(world, joint).point_a;
}

Joint make_joint(const World& world, std::string name, JointKind kind, int a, int b, const Vec3& at,
                 const Mat3& axes)
{
    Joint joint;
    joint.name = std::move(name);
    joint.kind = kind;
    const Vec3 point = held_point(world, b, held_point(world, a, at));
    joint.a = joint_end(world, a, point, axes);
    joint.b = joint_end(world, b, point, axes);
    return joint;
}

Joint make_rod(const World& world, std::string name, int a, int b, const Vec3& at, const Vec3& to)
{
    Joint joint = make_joint(world, std::move(name), JointKind::distance, a, b, at);
    joint.a = joint_end(world, a, at, Mat3::Identity());
    joint.b = joint_end(world, b, to, Mat3::Identity());
    joint.way.low = joint.way.high = (held_point(world, a, at) - held_point(world, b, to)).norm();
    return joint;
}

Joint make_gear(std::string name, const World& world, int first, int second, double ratio)
{
    Joint joint;
    joint.name = std::move(name);
    joint.kind = JointKind::gear;
    joint.hinges = {first, second};
    joint.ratio = ratio;
    // its own ends say which bodies it brings together: both hinges hold the others
    for (const auto& [end, hinge] : {std::pair(&joint.a, first), std::pair(&joint.b, second)}) {
        const Joint& of = world.joints[static_cast<std::size_t>(hinge)];
        end->body = answers_at(world, of.a) ? of.a.body : of.b.body;
    }
    return joint;
}

}  // namespace enduring
