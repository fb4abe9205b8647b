#include "chapters/12_joints/joint_laws.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

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

}  // namespace

bool is_turn(int part)
{
    return part == static_cast<int>(JointPart::lock_about) ||
           part == static_cast<int>(JointPart::drive_about);
}

bool is_drive(int part) { return part >= static_cast<int>(JointPart::drive_along); }

const JointDrive& drive_of(const Joint& joint, int part) { return is_turn(part) ? joint.turn : joint.way; }

int free_place(const Joint& joint, int part)
{
    return is_turn(part) ? free_turn(joint.kind) : free_way(joint.kind);
}

bool has_row(const Joint& joint, int part)
{
    if (joint.kind == JointKind::gear)
        return part == static_cast<int>(JointPart::lock_about);
    if (is_drive(part))
        return free_place(joint, part) >= 0 && drive_of(joint, part).pushes();
    for (int i = 0; i < 3; ++i)
        if (is_locked(joint, part, i) || is_limited(joint, part, i))
            return true;
    return false;
}

const Vec3& numbers_of(const JointMeasure& measure, int part)
{
    return is_turn(part) ? measure.about : measure.along;
}

void set_lock(const Joint& joint, int part, const Vec3& masses, double stiffness, ElementLaw& law)
{
    for (int i = 0; i < 3; ++i)
        if (is_locked(joint, part, i) || is_limited(joint, part, i))
            law.lines[static_cast<std::size_t>(i)].slope = stiffness * masses[i];
}

//! [speed_to_target]
double speed_to_target(const JointDrive& drive, double mass, double coordinate, double dt)
{
    const double left = *drive.motor_target - coordinate,
                 brake = dt * joint_choice.braking * drive.motor_most / mass;  // change of speed in a step
    // v^2 = 2 a (left - v dt): what is left behind this step is enough to stop in
    const double fastest = std::sqrt(brake * brake + 2 * brake / dt * std::abs(left)) - brake;
    return std::copysign(std::min(drive.motor_speed, fastest), left);
}
//! [speed_to_target]

void set_drive(const JointDrive& drive, double mass, double coordinate, double dt, double left,
               ElementLaw& law)
{
    law.lines[0].slope = drive.stiffness * dt * dt + drive.damping * dt;
    if (drive.motor_most > 0 && mass > 0) {
        const double speed = drive.motor_target ? speed_to_target(drive, mass, coordinate, left)
                                                : drive.motor_speed;
        law.lines[1].slope = joint_choice.motor * mass;
        law.lines[1].bias = -law.lines[1].slope * speed;
        law.lines[1].low = -drive.motor_most * dt;
        law.lines[1].high = drive.motor_most * dt;
    }
}

//! [lock_line]
/// A lock goes through its impulse at the velocity that acts now, less k dt times the error that is left at
/// the end of the step. So its impulse is right where there is no error any more, however stiff k is. A limit
/// is the same on one side.
/// @param error  of what is locked at the predicted end [m, rad]
/// @param acting impulse now [N s]
void aim(LineLaw& line, double error, double acting, double velocity, double dt)
{
    line.bias = -acting + line.slope / dt * error - line.slope * velocity;
}

namespace {

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

//! [rebound]
/// What has struck a limit leaves it in the next step with this velocity: the limit pushes until then, and no
/// further, to the other limit at most.
void send_back(LineLaw& line, double rebound, double to_other_limit, double dt)
{
    constexpr double infinite = std::numeric_limits<double>::infinity();
    line.low = rebound > 0 ? 0 : -infinite;
    line.high = rebound > 0 ? infinite : 0;
    line.bias = -line.slope * std::copysign(std::clamp(to_other_limit / dt, 0.0, std::abs(rebound)), rebound);
}

/// How far the other limit is, as the step begins, from what leaves a limit.
double way_to_other_limit(const JointDrive& drive, double rebound, double coordinate_t0)
{
    return rebound > 0 ? drive.high - coordinate_t0 : coordinate_t0 - drive.low;
}

/// Whether others push it on to the other limit within the same step.
bool meets_other_limit(const JointDrive& drive, double rebound, double coordinate, double acting)
{
    const double beyond = rebound > 0 ? coordinate - drive.high : drive.low - coordinate;
    return acting * rebound < 0 || (acting == 0 && beyond > 0);
}

}  // namespace

double rebound_of(const JointDrive& drive, double rate, double acting, double least)
{
    return acting * rate < 0 && std::abs(rate) > least ? -drive.bounce * rate : 0;
}
//! [rebound]

void follow_lock(const Joint& joint, const Vec3& numbers, const Vec3& acting, const Vec3& velocity, double dt,
                 ElementLaw& law)
{
    const double rebound = is_turn(law.part) ? joint.turn_rebound : joint.way_rebound;
    for (int i = 0; i < 3; ++i) {
        LineLaw& line = law.lines[static_cast<std::size_t>(i)];
        const double along_acting = law.axes.col(i).dot(acting),
                     along_velocity = law.axes.col(i).dot(velocity);
        if (is_locked(joint, law.part, i)) {
            const bool is_rod = joint.kind == JointKind::distance;
            aim(line, numbers[i] - (is_rod ? joint.way.low : 0), along_acting, along_velocity, dt);
        } else if (is_limited(joint, law.part, i)) {
            const JointDrive& drive = drive_of(joint, law.part);
            if (rebound != 0 && !meets_other_limit(drive, rebound, numbers[i], along_acting))
                send_back(line, rebound, way_to_other_limit(drive, rebound, numbers[i] - dt * along_velocity),
                          dt);
            else
                aim_at_limit(line, drive, numbers[i], along_acting, along_velocity, dt);
        }
    }
}

//! [spring_line]
void follow_spring(const Joint& joint, const Vec3& numbers, const Vec3& velocity, double dt, ElementLaw& law)
{
    const JointDrive& drive = drive_of(joint, law.part);
    const double stretch = numbers[free_place(joint, law.part)] - drive.rest,
                 along = law.axes.col(0).dot(velocity);
    law.lines[0].bias = drive.stiffness * dt * (stretch - dt * along);
}
//! [spring_line]

}  // namespace enduring
