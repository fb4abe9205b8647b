#include "common/simulation/joint.hpp"

#include "common/simulation/body_pose.hpp"
#include "common/simulation/joint_body.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring {
namespace {

Vec3 on_face(std::span<const Vec3> vertices, const JointEnd& end)
{
    Vec3 point = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i)
        point += end.weights[static_cast<Eigen::Index>(i)] *
                 vertices[static_cast<std::size_t>(end.vertices[i])];
    return point;
}

/// @param pose_of   Pose(body)
/// @param vertices  of a soft body
template <class PoseOf>
JointPose pose_by(const World& world, const Joint& joint, const PoseOf& pose_of,
                  std::span<const Vec3> (Body::*vertices)() const)
{
    const auto placed = [&](const JointEnd& end, Vec3& point, Mat3& axes) {
        const Body* const body = body_at(world, end);
        const Pose pose = body ? pose_of(*body) : Pose{};
        point = end.is_soft() ? on_face((body->*vertices)(), end) : pose.to_world(end.point);
        axes = (pose.orientation * end.frame).toRotationMatrix();
    };
    JointPose pose;
    placed(joint.a, pose.point_a, pose.axes_a);
    placed(joint.b, pose.point_b, pose.axes_b);
    return pose;
}

/// The turn from one orientation to another as axis times angle, in the axes of the first.
Vec3 turn_between(const Mat3& from, const Mat3& to)
{
    const Eigen::AngleAxisd turn(Mat3(from.transpose() * to));
    return turn.angle() * turn.axis();
}

/// The turn about the third axis that lies nearest to another one.
double turn_about_axis(const JointPose& pose, double near)
{
    const Vec3 x = pose.axes_a.col(0);
    const double angle = std::atan2(x.dot(pose.axes_b.col(1)), x.dot(pose.axes_b.col(0)));
    return near + std::remainder(angle - near, 2 * std::numbers::pi);
}

}  // namespace

void visit_state(StateArchive& archive, Joint& joint)
{
    archive.whole(joint.broken);
    archive.whole(joint.acts);
    for (Vec3* vector : {&joint.lock_force, &joint.lock_torque, &joint.force, &joint.torque})
        archive(*vector);
    for (double* number :
         {&joint.way_force, &joint.turn_torque, &joint.way_rebound, &joint.turn_rebound, &joint.angle})
        archive(*number);
}

JointPose committed_pose(const World& world, const Joint& joint)
{
    return pose_by(
        world, joint, [](const Body& body) { return committed_pose(body); }, &Body::positions_t0);
}

JointPose predicted_pose(const World& world, const Joint& joint, double dt)
{
    return pose_by(
        world, joint, [dt](const Body& body) { return predicted_pose(body, dt); }, &Body::positions_t1);
}

bool leaves_turns(JointKind kind)
{
    return kind == JointKind::ball || kind == JointKind::distance || kind == JointKind::gear;
}

//! [joint_axes]
JointAxes joint_axes(JointKind kind, const JointPose& pose)
{
    JointAxes axes;
    if (kind == JointKind::gear)
        return axes;
    if (kind == JointKind::distance)
        axes.along.col(0) = (pose.point_a - pose.point_b).stableNormalized();
    else
        axes.along = pose.axes_b;
    if (kind == JointKind::universal)
        axes.about.col(0) = pose.axes_a.col(0).cross(pose.axes_b.col(1)).stableNormalized();
    else if (!leaves_turns(kind))
        axes.about = pose.axes_b;
    return axes;
}
//! [joint_axes]

//! [joint_measure]
JointMeasure joint_measure(JointKind kind, const JointPose& pose, double angle)
{
    JointMeasure of;
    const Vec3 apart = pose.point_a - pose.point_b;
    if (kind == JointKind::distance)
        of.along[0] = apart.norm();
    else
        of.along = pose.axes_b.transpose() * apart;
    switch (kind) {
        case JointKind::hinge:
        case JointKind::cylinder:
            of.about = pose.axes_b.transpose() * pose.axes_b.col(2).cross(pose.axes_a.col(2));
            of.about[2] = turn_about_axis(pose, angle);
            break;
        case JointKind::universal: of.about[0] = pose.axes_a.col(0).dot(pose.axes_b.col(1)); break;
        case JointKind::slider:
        case JointKind::fixed: of.about = turn_between(pose.axes_b, pose.axes_a); break;
        case JointKind::ball:
        case JointKind::distance:
        case JointKind::gear: break;
    }
    return of;
}
//! [joint_measure]

int free_way(JointKind kind)
{
    if (kind == JointKind::distance)
        return 0;
    return kind == JointKind::slider || kind == JointKind::cylinder ? 2 : -1;
}

int free_turn(JointKind kind) { return kind == JointKind::hinge || kind == JointKind::cylinder ? 2 : -1; }

bool locks_along(JointKind kind, int place)
{
    return kind != JointKind::distance && kind != JointKind::gear && place != free_way(kind);
}

bool locks_about(JointKind kind, int place)
{
    if (kind == JointKind::universal)
        return place == 0;
    return !leaves_turns(kind) && place != free_turn(kind);
}

double way_of(const World& world, const Joint& joint)
{
    const int place = free_way(joint.kind);
    return place < 0 ? 0 : joint_measure(joint.kind, committed_pose(world, joint), joint.angle).along[place];
}

double turn_of(const World& world, const Joint& joint)
{
    const int place = free_turn(joint.kind);
    return place < 0 ? 0 : joint_measure(joint.kind, committed_pose(world, joint), joint.angle).about[place];
}

double joint_energy(const World& world)
{
    double sum = 0;
    const auto held = [](const JointDrive& spring, double coordinate) {
        const double stretch = coordinate - spring.rest;
        return spring.stiffness / 2 * stretch * stretch;
    };
    for (const Joint& joint : world.joints) {
        if (joint.broken)
            continue;
        if (joint.way.stiffness > 0)
            sum += held(joint.way, way_of(world, joint));
        if (joint.turn.stiffness > 0)
            sum += held(joint.turn, turn_of(world, joint));
    }
    return sum;
}

bool are_joined(const std::vector<Joint>& joints, int body, int other)
{
    return std::any_of(joints.begin(), joints.end(), [&](const Joint& joint) {
        return !joint.broken && !joint.bodies_touch &&
               ((joint.a.body == body && joint.b.body == other) ||
                (joint.a.body == other && joint.b.body == body));
    });
}

}  // namespace enduring
