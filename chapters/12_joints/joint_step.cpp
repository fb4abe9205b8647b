#include "chapters/12_joints/joint_step.hpp"

#include "chapters/12_joints/joint_laws.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/joint_body.hpp"

#include <algorithm>

namespace enduring {
namespace {

EndRates operator-(const EndRates& one, const EndRates& other)
{
    return {one.along - other.along, one.about - other.about};
}

JointRates gear_rates(const World& world, const Joint& joint, double dt)
{
    const auto turn_rate = [&](int number) {
        const Joint& hinge = world.joints[static_cast<std::size_t>(number)];
        const JointPose pose = committed_pose(world, hinge);
        const EndRates turn = end_rates(world, hinge.a, pose.point_a, dt) -
                              end_rates(world, hinge.b, pose.point_a, dt);
        return pose.axes_b.col(2).dot(turn.about);
    };
    JointRates rates;
    rates[0].about = (turn_rate(joint.hinges[1]) - joint.ratio * turn_rate(joint.hinges[0])) *
                     gear_axis(world, joint);
    return rates;
}

/// The points of both bodies that a joint pushes [m].
std::array<Vec3, 2> points_of(const World& world, const Joint& joint)
{
    const JointPose pose = committed_pose(world, joint);
    return {pose.point_a, joint.kind == JointKind::distance ? pose.point_b : pose.point_a};
}

JointRates rates_of(const World& world, const Joint& joint, double dt)
{
    if (joint.kind == JointKind::gear)
        return gear_rates(world, joint, dt);
    const auto [point_a, point_b] = points_of(world, joint);
    return {end_rates(world, joint.a, point_a, dt), end_rates(world, joint.b, point_b, dt)};
}

/// The rates that tell the work of an impulse. Of a rigid body the mean of those at both ends of the step: a
/// step of a fall keeps E + dt / 2 g . p, and the other half is its. A soft body's implicit step gains the
/// impulse times the velocity behind it, at most.
/// @param fall  part of what gravity does in the step that is taken off: 1 for the change of E, 1/2 for that
///     of E + dt / 2 g . p. Where a body is locked, gravity does less.
/// @param point  that the joint pushes, at the start of the step [m]
EndRates working_rates(const World& world, const JointEnd& end, const Vec3& point, const EndRates& before,
                       const EndRates& after, double fall, double dt)
{
    const RigidBody* const rigid = rigid_at(world, end);
    if (!rigid)
        return after;
    const Vec3 gravity = rigid->gravity_on(world.gravity);
    return {(before.along + after.along) / 2 - fall * dt * rigid->motion().acceleration_at(point, gravity),
            (before.about + after.about) / 2 - fall * dt * rigid->motion().angular_acceleration(gravity)};
}

/// The work of springs and dampers of a joint, whose energy is held or lost, by the velocities of the step
/// [J].
double spring_work(const JointDrive& drive, double coordinate, double rate, double dt)
{
    return -dt * (drive.stiffness * (coordinate - drive.rest) + drive.damping * rate) * rate;
}

double work_on(const Joint& joint, const EndRates& rates, double dt)
{
    return dt * (joint.force.dot(rates.along) + joint.torque.dot(rates.about));
}

/// What a joint's drives have done in a step [J].
struct DriveWork {
    double springs = 0, motors = 0;
};

/// @param working, after  of A against B, see working_rates(), and behind the step
DriveWork work_of_drives(const World& world, const Joint& joint, const EndRates& working,
                         const EndRates& after, double dt)
{
    const JointAxes axes = joint_axes(joint.kind, committed_pose(world, joint));
    const JointMeasure measure = joint_measure(joint.kind, predicted_pose(world, joint, dt), joint.angle);
    DriveWork sum;
    const auto add = [&](const JointDrive& drive, double coordinate, double rate, double mean, double push) {
        const double of_spring = spring_work(drive, coordinate, rate, dt);
        sum.springs += of_spring;
        if (drive.motor_most > 0)
            sum.motors += dt * push * mean - of_spring;
    };
    if (const int place = free_way(joint.kind); place >= 0) {
        const Vec3 along = axes.along.col(place);
        add(joint.way, measure.along[place], along.dot(after.along), along.dot(working.along),
            joint.way_force);
    }
    if (const int place = free_turn(joint.kind); place >= 0) {
        const Vec3 about = axes.about.col(place);
        add(joint.turn, measure.about[place], about.dot(after.about), about.dot(working.about),
            joint.turn_torque);
    }
    return sum;
}

//! [weight_carried]
/// What a step adds to the energy by gravity alone [J]. Velocities are half a step behind positions: a step
/// keeps E + dt / 2 g . p, so E falls by m (g dt)^2 / 2 where a body falls, and rises by half of what carries
/// it times g dt, as where a machine lifts itself. Joints get the same by working_rates(). What is held or
/// soft falls with less than this, and only what carries it counts.
double weight_carried(const World& world, const Contacts& contacts, double dt)
{
    double sum = 0;
    for (const auto& body : world.bodies)
        if (const auto* const rigid = dynamic_cast<const RigidBody*>(body.get());
            rigid && rigid->motion().free_directions().hold_none())
            sum -= rigid->mass() * (dt * rigid->gravity_on(world.gravity)).squaredNorm() / 2;
    for (const Contact& contact : contacts)
        for (int i = 0; contact.answered() && i < contact.vertex_count(); ++i) {
            const auto n = static_cast<std::size_t>(i);
            const Vec3 fall =
                dt * body_of_vertex(world, contact, i).acceleration(contact.vertices[n], world.gravity);
            sum -= contact.weights[n] * (contact.impulse + contact.friction).dot(fall) / 2;
        }
    return sum;
}
//! [weight_carried]

//! [note_rebounds]
void note_rebounds(const World& world, Joint& joint, const EndRates& before, double dt)
{
    const JointAxes axes = joint_axes(joint.kind, committed_pose(world, joint));
    const double least = joint_choice.least_bounce * world.gravity.norm() * dt;
    joint.way_rebound = joint.turn_rebound = 0;
    if (const int place = free_way(joint.kind); place >= 0 && joint.way.bounce > 0)
        joint.way_rebound = rebound_of(joint.way, axes.along.col(place).dot(before.along),
                                       joint.lock_force[place], least);
    if (const int place = free_turn(joint.kind); place >= 0 && joint.turn.bounce > 0)
        joint.turn_rebound = rebound_of(joint.turn, axes.about.col(place).dot(before.about),
                                        joint.lock_torque[place], least / body_at(world, joint.a)->size());
}
//! [note_rebounds]

}  // namespace

std::vector<JointRates> joint_rates(const World& world, double dt)
{
    std::vector<JointRates> all;
    all.reserve(world.joints.size());
    for (const Joint& joint : world.joints)
        all.push_back(rates_of(world, joint, dt));
    return all;
}

//! [book]
void book_joints(World& world, const Contacts& contacts, const std::vector<JointRates>& before, double dt)
{
    world.attempt.added_energy += weight_carried(world, contacts, dt);
    double held_all = 0;
    for (std::size_t i = 0; i < world.joints.size(); ++i) {
        Joint& joint = world.joints[i];
        if (!joint.acts)
            continue;
        const JointRates after = rates_of(world, joint, dt);
        const std::array<Vec3, 2> points = points_of(world, joint);
        const auto working = [&](std::size_t end, double fall) {
            return working_rates(world, end == 0 ? joint.a : joint.b, points[end], before[i][end], after[end],
                                 fall, dt);
        };
        const EndRates of_a = working(0, 1), of_b = working(1, 1);
        double given = 0;  // by what moves as given
        if (const Body* const body = body_at(world, joint.a); body && body->is_static())
            given -= work_on(joint, of_a, dt);
        if (const Body* const body = body_at(world, joint.b); body && body->is_static())
            given += work_on(joint, of_b, dt);
        const EndRates without_fall = working(0, 0.5) - working(1, 0.5);
        const DriveWork drives = work_of_drives(world, joint, without_fall, after[0] - after[1], dt);
        const double by_fall = work_on(joint, of_a - of_b, dt) - work_on(joint, without_fall, dt),
                     held = work_on(joint, without_fall, dt) - drives.springs - drives.motors;
        world.driven += drives.motors + given;
        world.attempt.added_energy += by_fall + drives.motors + given;
        // what leaves a limit has lost at it what it gets back
        const bool sends_back = joint.way_rebound != 0 || joint.turn_rebound != 0;
        (sends_back ? world.attempt.added_energy : held_all) += held;
        note_rebounds(world, joint, before[i][0] - before[i][1], dt);
    }
    world.attempt.added_energy += std::min(0.0, held_all);
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
