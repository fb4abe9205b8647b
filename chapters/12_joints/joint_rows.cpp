#include "chapters/12_joints/joint_rows.hpp"

#include "common/simulation/joint_body.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

using Motion = Eigen::Matrix<double, 3, 6>;

bool is_turn(int part)
{
    return part == static_cast<int>(JointPart::lock_about) ||
           part == static_cast<int>(JointPart::drive_about);
}

bool is_drive(int part) { return part >= static_cast<int>(JointPart::drive_along); }

const JointDrive& drive_of(const Joint& joint, int part) { return is_turn(part) ? joint.turn : joint.way; }

/// Where among the three numbers of a row the free one is; -1 where there is none.
int free_place(const Joint& joint, int part)
{
    return is_turn(part) ? free_turn(joint.kind) : free_way(joint.kind);
}

bool is_locked(const Joint& joint, int part, int place)
{
    if (is_turn(part) ? locks_about(joint.kind, place) : locks_along(joint.kind, place))
        return true;
    const JointDrive& drive = drive_of(joint, part);
    return place == free_place(joint, part) && drive.low == drive.high;  // a rod
}

bool is_limited(const Joint& joint, int part, int place)
{
    const JointDrive& drive = drive_of(joint, part);
    return place == free_place(joint, part) && (std::isfinite(drive.low) || std::isfinite(drive.high));
}

//! [levers]
/// How the velocity that a row sees follows from both bodies' coordinates: that of A's point against the point of B in the same place, but for a
/// distance, which has two points; or that of the turn.
std::vector<VertexMotion> parts_of(const World& world, const StepProblem& step, const Joint& joint,
                                   const JointPose& pose, int part)
{
    std::vector<VertexMotion> parts;
    const auto add = [&](const JointEnd& end, const Vec3& point, double sign) {
        const RigidBody* const body = rigid_at(world, end);
        const int first = body ? first_coordinate(step, end.body) : -1;
        if (first < 0)
            return;
        VertexMotion motion;
        motion.first = first;
        motion.rate = sign * (is_turn(part) ? body->motion_of_turn()
                                            : body->motion_of_point(point - body->motion().pose().position));
        parts.push_back(motion);
    };
    add(joint.a, pose.point_a, 1);
    add(joint.b, joint.kind == JointKind::distance ? pose.point_b : pose.point_a, -1);
    return parts;
}
//! [levers]

/// Of a row, the mass or inertia that each of its lines feels; 0 where nothing moves.
Vec3 masses_of(const StepProblem& step, const PairRow& row, const Mat3& axes)
{
    const Mat3 response = row.response(step.problem.blocks);
    Vec3 masses;
    for (int i = 0; i < 3; ++i)
        masses[i] = mass_along(axes.col(i), response);
    return masses;
}

/// What counts as the rounding of a coordinate of a joint [m]; of a turn it is that of its numbers [rad].
double rounding_of(const JointPose& pose, int part)
{
    constexpr double digits = 16 * std::numeric_limits<double>::epsilon();
    return is_turn(part) ? digits : digits * std::max(1e-3, pose.point_a.cwiseAbs().maxCoeff());
}

/// The slopes of a lock's lines, which the step keeps: k dt^2 with k for the mass that each of them feels.
void set_lock(const Joint& joint, int part, const Vec3& masses, ElementLaw& law)
{
    for (int i = 0; i < 3; ++i)
        if (is_locked(joint, part, i) || is_limited(joint, part, i))
            law.lines[static_cast<std::size_t>(i)].slope = joint_choice.k_dt2_over_m * masses[i];
}

/// A spring with a damper is the first line of a drive, a motor the second, both along the free axis.
void set_drive(const JointDrive& drive, double mass, double dt, ElementLaw& law)
{
    law.lines[0].slope = drive.stiffness * dt * dt + drive.damping * dt;
    if (drive.motor_most > 0) {
        law.lines[1].slope = joint_choice.motor * mass;
        law.lines[1].bias = -law.lines[1].slope * drive.motor_speed;
        law.lines[1].low = -drive.motor_most * dt;
        law.lines[1].high = drive.motor_most * dt;
    }
}

/// What a row has pushed in this step so far, along its axes.
Vec3 pushed_so_far(const Joint& joint, int part, const Mat3& axes, double dt)
{
    switch (static_cast<JointPart>(part)) {
        case JointPart::lock_along: return dt * axes * joint.lock_force;
        case JointPart::lock_about: return dt * axes * joint.lock_torque;
        case JointPart::drive_along: return dt * joint.way_force * axes.col(0);
        default: return dt * joint.turn_torque * axes.col(0);
    }
}

/// Whether a joint has this row at all.
bool has_row(const Joint& joint, int part)
{
    if (is_drive(part))
        return free_place(joint, part) >= 0 && drive_of(joint, part).pushes();
    for (int i = 0; i < 3; ++i)
        if (is_locked(joint, part, i) || is_limited(joint, part, i))
            return true;
    return false;
}

void add_row(const World& world, StepProblem& step, int element, const JointPose& pose, int part)
{
    const Joint& joint = world.joints[static_cast<std::size_t>(element)];
    const double dt = step.problem.step.dt;
    const JointAxes both = joint_axes(joint.kind, pose);
    ElementLaw law;
    law.element = element;
    law.part = part;
    law.axes = is_turn(part) ? both.about : both.along;
    if (is_drive(part))
        law.axes = law.axes.col(free_place(joint, part)) * Vec3(1, 1, 0).transpose();
    // A step begins without forces: those of the last one that cancel each other then would not do so now, and grow from step to step.
    const Vec3 acting = joint.acts ? pushed_so_far(joint, part, law.axes, dt) : Vec3(Vec3::Zero());
    law.begin = acting;
    add_element_row(step, law, parts_of(world, step, joint, pose, part), acting);
    ElementLaw& own = step.problem.elements.back();
    const Vec3 masses = masses_of(step, step.problem.rows.back(), own.axes);
    if (is_drive(part)) {
        set_drive(drive_of(joint, part), masses[0], dt, own);
        return;
    }
    set_lock(joint, part, masses, own);
    own.rounding = joint_choice.k_dt2_over_m * std::sqrt(masses.maxCoeff()) * rounding_of(pose, part) / dt;
}

//! [lock_line]
/// A lock goes through its impulse at the velocity that acts now, less k dt times the error that is left at the end of the step. So its impulse is right where
/// there is no error any more, however stiff k is. A limit is the same on one side.
/// @param error  of what is locked at the predicted end [m, rad]
/// @param acting impulse now [N s]
void aim(LineLaw& line, double error, double acting, double velocity, double dt)
{
    line.bias = -acting + line.slope / dt * error - line.slope * velocity;
}

void aim_at_limit(LineLaw& line, const JointDrive& drive, double coordinate, double acting, double velocity,
                  double dt)
{
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const double above = coordinate - drive.low, below = drive.high - coordinate;
    const bool at_low = acting > 0 || (acting == 0 && above < below);
    line.low = at_low ? 0 : -infinite;
    line.high = at_low ? infinite : 0;
    aim(line, at_low ? above : -below, acting, velocity, dt);
}
//! [lock_line]

void follow_lock(const Joint& joint, const JointMeasure& measure, double dt, const PairRow& row,
                 ElementLaw& law)
{
    const Vec3& numbers = is_turn(law.part) ? measure.about : measure.along;
    for (int i = 0; i < 3; ++i) {
        LineLaw& line = law.lines[static_cast<std::size_t>(i)];
        const double acting = law.axes.col(i).dot(row.acting), velocity = law.axes.col(i).dot(row.velocity);
        if (is_locked(joint, law.part, i)) {
            const bool is_rod = joint.kind == JointKind::distance;
            aim(line, numbers[i] - (is_rod ? joint.way.low : 0), acting, velocity, dt);
        } else if (is_limited(joint, law.part, i)) {
            aim_at_limit(line, drive_of(joint, law.part), numbers[i], acting, velocity, dt);
        }
    }
}

//! [spring_line]
/// A spring pushes by its stretch at the end of the step, a damper by the velocity of the step.
void follow_spring(const Joint& joint, const JointMeasure& measure, double dt, const PairRow& row,
                   ElementLaw& law)
{
    const JointDrive& drive = drive_of(joint, law.part);
    const Vec3& numbers = is_turn(law.part) ? measure.about : measure.along;
    const double stretch = numbers[free_place(joint, law.part)] - drive.rest,
                 velocity = law.axes.col(0).dot(row.velocity);
    law.lines[0].bias = drive.stiffness * dt * (stretch - dt * velocity);
}
//! [spring_line]

}  // namespace

std::vector<ElementBodies> joined_bodies(const World& world)
{
    std::vector<ElementBodies> all;
    all.reserve(world.joints.size());
    for (const Joint& joint : world.joints) {
        ElementBodies& of = all.emplace_back();
        if (joint.broken)
            continue;
        of.a = rigid_at(world, joint.a) ? joint.a.body : -1;
        of.b = rigid_at(world, joint.b) ? joint.b.body : -1;
        if (joint.way.pushes())
            of.force += joint.way.most(way_of(world, joint));
        if (joint.turn.pushes() && of.a >= 0)  // with a lever of the body's size
            of.force += joint.turn.most(turn_of(world, joint)) / rigid_at(world, joint.a)->size();
    }
    return all;
}

void add_joint_rows(const World& world, StepProblem& step)
{
    for (const int element : step.elements) {
        const Joint& joint = world.joints[static_cast<std::size_t>(element)];
        const JointPose pose = committed_pose(world, joint);
        for (int part = 0; part < 4; ++part)
            if (has_row(joint, part))
                add_row(world, step, element, pose, part);
    }
}

void follow_joints(const World& world, StepProblem& step)
{
    const double dt = step.problem.step.dt;
    const Eigen::VectorXd velocities = velocities_of(world, step);
    JointMeasure measure;
    int measured = -1;
    for (std::size_t i = 0; i < step.problem.elements.size(); ++i) {
        ElementLaw& law = step.problem.elements[i];
        PairRow& row = step.problem.rows[step.of_row.size() + i];
        const Joint& joint = world.joints[static_cast<std::size_t>(law.element)];
        if (law.element != measured)
            measure = joint_measure(joint.kind, predicted_pose(world, joint, dt), joint.angle);
        measured = law.element;
        row.velocity = row.rate_of(velocities);
        if (is_drive(law.part))
            follow_spring(joint, measure, dt, row, law);
        else
            follow_lock(joint, measure, dt, row, law);
    }
}

void remember_joints(World& world, const StepProblem& step)
{
    const double dt = step.problem.step.dt;
    for (const int element : step.elements) {
        Joint& joint = world.joints[static_cast<std::size_t>(element)];
        joint.acts = true;
        joint.force.setZero();
        joint.torque.setZero();
    }
    for (std::size_t i = 0; i < step.problem.elements.size(); ++i) {
        const ElementLaw& law = step.problem.elements[i];
        const Vec3 force = step.problem.rows[step.of_row.size() + i].acting / dt,
                   along = law.axes.transpose() * force;
        Joint& joint = world.joints[static_cast<std::size_t>(law.element)];
        (is_turn(law.part) ? joint.torque : joint.force) += force;
        switch (static_cast<JointPart>(law.part)) {
            case JointPart::lock_along: joint.lock_force = along; break;
            case JointPart::lock_about: joint.lock_torque = along; break;
            case JointPart::drive_along: joint.way_force = along[0]; break;
            case JointPart::drive_about: joint.turn_torque = along[0]; break;
        }
    }
}

ForceElements joint_elements() { return {joined_bodies, add_joint_rows, follow_joints, remember_joints}; }

}  // namespace enduring
