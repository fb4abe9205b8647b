#include "chapters/12_joints/joint_rows.hpp"

#include "chapters/07_implicit_contact/whole_bodies.hpp"
#include "chapters/12_joints/joint_motion.hpp"
#include "common/simulation/joint_body.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

/// Of a row, the mass or inertia that each of its lines feels; 0 where nothing moves.
Vec3 masses_of(const World& world, const StepProblem& step, const PairRow& row,
               std::span<const VertexShare> soft, const Mat3& axes)
{
    const Mat3 response = row.response(step.problem.blocks) + response_of_whole(world, soft, step);
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

Mat3 axes_of(const Joint& joint, const JointPose& pose, int part)
{
    if (joint.kind == JointKind::gear)
        return Vec3::UnitX() * Vec3::UnitX().transpose();
    const JointAxes both = joint_axes(joint.kind, pose);
    const Mat3& axes = is_turn(part) ? both.about : both.along;
    return is_drive(part) ? Mat3(axes.col(free_place(joint, part)) * Vec3(1, 1, 0).transpose()) : axes;
}

void add_row(const World& world, StepProblem& step, int element, const JointPose& pose, int part)
{
    const Joint& joint = world.joints[static_cast<std::size_t>(element)];
    const double dt = step.problem.step.dt;
    ElementLaw law;
    law.element = element;
    law.part = part;
    law.axes = axes_of(joint, pose, part);
    // A step begins without forces: those of the last one that cancel each other then would not do so now,
    // and grow from step to step.
    const Vec3 acting = joint.acts ? pushed_so_far(joint, part, law.axes, dt) : Vec3(Vec3::Zero());
    law.begin = acting;
    const RowMotion motion = joint.kind == JointKind::gear ? motion_of_gear(world, step, joint)
                                                           : motion_of_row(world, step, joint, pose, part);
    law.given = motion.given;
    add_element_row(step, law, motion.parts, acting);
    ElementLaw& own = step.problem.elements.back();
    const std::vector<VertexShare> soft = is_turn(part) ? std::vector<VertexShare>{} : soft_shares(joint);
    const Vec3 masses = masses_of(world, step, step.problem.rows.back(), soft, own.axes);
    if (is_drive(part)) {
        const double coordinate = is_turn(part) ? turn_of(world, joint) : way_of(world, joint);
        set_drive(drive_of(joint, part), masses[0], coordinate, dt, dt + world.attempt.behind, own);
        return;
    }
    const double stiffness = soft.empty() ? joint_choice.k_dt2_over_m : joint_choice.soft_k_dt2_over_m;
    if (joint.kind == JointKind::gear)
        own.lines[0].slope = stiffness * masses[0];
    else
        set_lock(joint, part, masses, stiffness, own);
    own.rounding = stiffness * std::sqrt(masses.maxCoeff()) * rounding_of(pose, part) / dt;
}

/// What this does to a body by its own size [N], for what pairs may have to bear.
double force_of_drives(const World& world, const Joint& joint)
{
    double force = 0;
    if (joint.way.pushes())
        force += joint.way.most(way_of(world, joint));
    if (joint.turn.pushes() && answers_at(world, joint.a))  // with a lever of the body's size
        force += joint.turn.most(turn_of(world, joint)) / body_at(world, joint.a)->size();
    return force;
}

}  // namespace

std::vector<ElementBodies> joined_bodies(const World& world)
{
    std::vector<ElementBodies> all;
    all.reserve(world.joints.size());
    for (const Joint& joint : world.joints) {
        ElementBodies& of = all.emplace_back();
        if (!holds(world, joint))
            continue;
        of.a = answers_at(world, joint.a) ? joint.a.body : -1;
        of.b = answers_at(world, joint.b) ? joint.b.body : -1;
        of.force = force_of_drives(world, joint);
        of.vertices = soft_shares(joint);
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
        if (law.element < 0)  // of another kind
            continue;
        PairRow& row = step.problem.rows[step.of_row.size() + i];
        const Joint& joint = world.joints[static_cast<std::size_t>(law.element)];
        row.velocity = row.rate_of(velocities) + law.given;
        if (joint.kind == JointKind::gear) {
            aim(law.lines[0], gear_error(world, joint, dt), row.acting.x(), row.velocity.x(), dt);
            continue;
        }
        if (law.element != measured)
            measure = joint_measure(joint.kind, predicted_pose(world, joint, dt), joint.angle);
        measured = law.element;
        if (is_drive(law.part))
            follow_spring(joint, numbers_of(measure, law.part), row.velocity, dt, law);
        else
            follow_lock(joint, numbers_of(measure, law.part), row.acting, row.velocity, dt, law);
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
        if (law.element < 0)
            continue;
        const Vec3 force = step.problem.rows[step.of_row.size() + i].acting / dt,
                   along = law.axes.transpose() * force;
        Joint& joint = world.joints[static_cast<std::size_t>(law.element)];
        if (joint.kind == JointKind::gear)
            joint.torque = force.x() * gear_axis(world, joint);
        else
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
