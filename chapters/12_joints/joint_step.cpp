#include "chapters/12_joints/joint_step.hpp"

#include "common/simulation/joint_body.hpp"

namespace enduring {
namespace {

/// Of a body's point in the world, and its angular velocity that belongs to its momentum: within a step a free body turns by another
/// one.
JointRates rates_of(const RigidBody* body, const Vec3& point)
{
    if (!body)
        return {};
    const RigidMotion& motion = body->motion();
    const RigidMotion::State state = motion.state();
    const Vec3 turning = motion.inverse_inertia() * state.spin_momentum;
    return {state.velocity + turning.cross(point - state.pose.position), turning};
}

JointRates rates_of(const World& world, const Joint& joint)
{
    const JointPose pose = committed_pose(world, joint);
    const Vec3& other = joint.kind == JointKind::distance ? pose.point_b : pose.point_a;
    const JointRates a = rates_of(rigid_at(world, joint.a), pose.point_a),
                     b = rates_of(rigid_at(world, joint.b), other);
    return {a.along - b.along, a.about - b.about};
}

/// What gravity does in a step to the relative velocity of a joint's points [m/s].
Vec3 relative_fall(const World& world, const Joint& joint, double dt)
{
    const auto fall = [&](const JointEnd& end) {
        const RigidBody* const body = rigid_at(world, end);
        return body ? Vec3(dt * body->gravity_on(world.gravity)) : Vec3(Vec3::Zero());
    };
    return fall(joint.a) - fall(joint.b);
}

}  // namespace

std::vector<JointRates> joint_rates(const World& world)
{
    std::vector<JointRates> all;
    all.reserve(world.joints.size());
    for (const Joint& joint : world.joints)
        all.push_back(rates_of(world, joint));
    return all;
}

namespace {

/// The work of springs and dampers of a joint, whose energy is held or lost, by the velocities of the step [J].
double spring_work(const JointDrive& drive, double coordinate, double rate, double dt)
{
    return -dt * (drive.stiffness * (coordinate - drive.rest) + drive.damping * rate) * rate;
}

}  // namespace

//! [book]
void book_joints(World& world, const std::vector<JointRates>& before, double dt)
{
    for (std::size_t i = 0; i < world.joints.size(); ++i) {
        const Joint& joint = world.joints[i];
        if (!joint.acts)
            continue;
        const JointRates after = rates_of(world, joint);
        const Vec3 fall = relative_fall(world, joint, dt);
        // of the mean of the velocities at both ends of the step; a step of a fall keeps E + dt / 2 g . p, and the other half is its
        const double all = dt * (joint.force.dot((before[i].along + after.along) / 2 - fall) +
                                 joint.torque.dot((before[i].about + after.about) / 2));
        const JointPose start = committed_pose(world, joint), end = predicted_pose(world, joint, dt);
        const JointAxes axes = joint_axes(joint.kind, start);
        const JointMeasure measure = joint_measure(joint.kind, end, joint.angle);
        double springs = 0, motors = 0;
        const auto add = [&](const JointDrive& drive, double coordinate, double rate, double mean,
                             double push) {
            const double of_spring = spring_work(drive, coordinate, rate, dt);
            springs += of_spring;
            if (drive.motor_most > 0)
                motors += dt * push * mean - of_spring;
        };
        if (const int place = free_way(joint.kind); place >= 0) {
            const Vec3 along = axes.along.col(place);
            add(joint.way, measure.along[place], along.dot(after.along),
                along.dot(before[i].along + after.along - fall) / 2, joint.way_force);
        }
        if (const int place = free_turn(joint.kind); place >= 0) {
            const Vec3 about = axes.about.col(place);
            add(joint.turn, measure.about[place], about.dot(after.about),
                about.dot(before[i].about + after.about) / 2, joint.turn_torque);
        }
        world.driven += motors;
        world.attempt.put_in += all - springs;
    }
}
//! [book]

//! [end]
void end_joints(World& world)
{
    for (Joint& joint : world.joints) {
        if (joint.broken)
            continue;
        joint.angle = turn_of(world, joint);
        if (joint.acts && joint.force.norm() > joint.breaks_at) {
            joint.broken = true;
            joint.lock_force.setZero();
            joint.lock_torque.setZero();
            joint.way_force = joint.turn_torque = 0;
        }
    }
}
//! [end]

}  // namespace enduring
