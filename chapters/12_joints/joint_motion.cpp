#include "chapters/12_joints/joint_motion.hpp"

#include "chapters/12_joints/joint_laws.hpp"
#include "common/simulation/body_pose.hpp"
#include "common/simulation/joint_body.hpp"

#include <utility>

namespace enduring {
namespace {

/// The mean motion of a body that moves as given, in a step [m/s, rad/s].
EndRates given_rates(const Body& body, const Vec3& point, double dt)
{
    const Pose start = committed_pose(body), end = predicted_pose(body, dt);
    return {(end.to_world(start.to_body(point)) - point) / dt, mean_turn_rate(start, end, dt)};
}

void add_soft_end(const World& world, const StepProblem& step, const JointEnd& end, double sign,
                  RowMotion& motion)
{
    for (std::size_t i = 0; i < 3; ++i) {
        const double weight = sign * end.weights[static_cast<Eigen::Index>(i)];
        if (weight == 0)
            continue;
        if (auto part = motion_of_vertex(world, step, end.body, end.vertices[i], 1)) {
            part->rate *= weight;
            motion.parts.push_back(*part);
        } else {  // a held node, which may move as given
            motion.given += weight * body_at(world, end)->velocity(end.vertices[i]);
        }
    }
}

void add_rigid_end(const World& world, const StepProblem& step, const JointEnd& end, const Vec3& point,
                   bool turns, double sign, RowMotion& motion)
{
    const RigidBody* const body = rigid_at(world, end);
    const int first = body ? first_coordinate(step, end.body) : -1;
    if (first < 0)
        return;
    VertexMotion part;
    part.first = first;
    part.rate = sign * (turns ? body->motion_of_turn()
                              : body->motion_of_point(point - body->motion().pose().position));
    motion.parts.push_back(part);
}

const Joint& hinge_of(const World& world, const Joint& gear, std::size_t which)
{
    return world.joints[static_cast<std::size_t>(gear.hinges[which])];
}

/// @param pose_of  JointPose(hinge)
template <class PoseOf>
double error_by(const World& world, const Joint& gear, const PoseOf& pose_of)
{
    const auto turn = [&](std::size_t which) {
        const Joint& hinge = hinge_of(world, gear, which);
        return joint_measure(hinge.kind, pose_of(hinge), hinge.angle).about[2];
    };
    return turn(1) - gear.ratio * turn(0);
}

}  // namespace

//! [levers]
RowMotion motion_of_row(const World& world, const StepProblem& step, const Joint& joint,
                        const JointPose& pose, int part)
{
    RowMotion motion;
    const auto add = [&](const JointEnd& end, const Vec3& point, double sign) {
        const Body* const body = body_at(world, end);
        if (end.is_soft()) {
            add_soft_end(world, step, end, sign, motion);
        } else if (body && body->is_static()) {
            const EndRates given = given_rates(*body, point, step.problem.step.dt);
            motion.given += sign * (is_turn(part) ? given.about : given.along);
        } else {
            add_rigid_end(world, step, end, point, is_turn(part), sign, motion);
        }
    };
    add(joint.a, pose.point_a, 1);
    add(joint.b, joint.kind == JointKind::distance ? pose.point_b : pose.point_a, -1);
    return motion;
}
//! [levers]

//! [gear]
RowMotion motion_of_gear(const World& world, const StepProblem& step, const Joint& joint)
{
    RowMotion all;
    for (const auto& [which, factor] :
         {std::pair(std::size_t{1}, 1.0), std::pair(std::size_t{0}, -joint.ratio)}) {
        const Joint& hinge = hinge_of(world, joint, which);
        const JointPose pose = committed_pose(world, hinge);
        const Vec3 axis = factor * pose.axes_b.col(2);
        RowMotion turn = motion_of_row(world, step, hinge, pose, static_cast<int>(JointPart::lock_about));
        for (VertexMotion& part : turn.parts) {
            part.rate = (Vec3::UnitX() * axis.transpose() * part.rate).eval();
            all.parts.push_back(part);
        }
        all.given.x() += axis.dot(turn.given);
    }
    return all;
}
//! [gear]

std::vector<VertexShare> soft_shares(const Joint& joint)
{
    std::vector<VertexShare> shares;
    for (const auto& [end, sign] : {std::pair(&joint.a, 1.0), std::pair(&joint.b, -1.0)})
        for (std::size_t i = 0; end->is_soft() && i < 3; ++i)
            if (const double weight = end->weights[static_cast<Eigen::Index>(i)]; weight != 0)
                shares.push_back({end->body, end->vertices[i], sign * weight});
    return shares;
}

bool holds(const World& world, const Joint& joint)
{
    return !joint.broken && (joint.kind != JointKind::gear ||
                             (!hinge_of(world, joint, 0).broken && !hinge_of(world, joint, 1).broken));
}

double gear_error(const World& world, const Joint& joint, double dt)
{
    return error_by(world, joint, [&](const Joint& hinge) { return predicted_pose(world, hinge, dt); });
}

double gear_error(const World& world, const Joint& joint)
{
    return error_by(world, joint, [&](const Joint& hinge) { return committed_pose(world, hinge); });
}

Vec3 gear_axis(const World& world, const Joint& joint)
{
    return committed_pose(world, hinge_of(world, joint, 1)).axes_b.col(2);
}

/// Of a rigid body, the angular velocity is the one that belongs to its momentum: within a step a free body
/// turns by another one.
EndRates end_rates(const World& world, const JointEnd& end, const Vec3& point, double dt)
{
    const Body* const body = body_at(world, end);
    if (!body)
        return {};
    if (end.is_soft()) {
        EndRates rates;
        for (std::size_t i = 0; i < 3; ++i)
            rates.along += end.weights[static_cast<Eigen::Index>(i)] * body->velocity(end.vertices[i]);
        return rates;
    }
    const RigidBody* const rigid = rigid_at(world, end);
    if (!rigid)
        return given_rates(*body, point, dt);
    const RigidMotion& motion = rigid->motion();
    const RigidMotion::State state = motion.state();
    const Vec3 turning = motion.inverse_inertia() * state.spin_momentum;
    return {state.velocity + turning.cross(point - state.pose.position), turning};
}

}  // namespace enduring
