#pragma once

#include "chapters/07_implicit_contact/force_element.hpp"
#include "common/simulation/joint.hpp"

namespace enduring {

//! [joint_choice]
/// How stiff a joint is while its impulse is found. It leaves nothing of it: each round takes the impulse of
/// the last one for the force that the spring begins with.
struct JointChoice {
    /// h = k dt^2 / m of each direction that is locked, with the mass that it feels. A hundredth: a heavy
    /// body on a light chain takes some times the rounds. Ten times: the rounding of coordinates is all that
    /// is left.
    double k_dt2_over_m = 1e7;
    /// The same where a soft body is held, whose mass is known by what was learned of it and whose velocities
    /// are solved for to ten digits. A tenth: a round more. A hundred times: what the solve of the elements
    /// leaves is answered by the joint, and the rounds do not end.
    double soft_k_dt2_over_m = 1e4;
    /// The same of a motor that is not at its most: it misses its speed by this part of what its load does in
    /// a step.
    double motor = 1e7;
    /// Part of its largest force by which a motor with a target counts on stopping there; the rest is for its
    /// load. A tenth: it takes three times as long. Twice: what has a load in the direction of its motion
    /// comes too far.
    double braking = 0.5;
    /// The slowest meeting with a limit that bounces, in g dt. A tenth: what rests on a limit trembles. Ten
    /// times: a bounce ends sooner.
    double least_bounce = 2;
};
inline constexpr JointChoice joint_choice;
//! [joint_choice]

/// Rows of a joint: what it locks or limits along and about its axes, and what its springs and motors push
/// there. A gear has the second one alone.
enum class JointPart : int { lock_along, lock_about, drive_along, drive_about };

bool is_turn(int part);
bool is_drive(int part);
const JointDrive& drive_of(const Joint& joint, int part);
/// Where among the three numbers of a row the free one is; -1 where there is none.
int free_place(const Joint& joint, int part);
/// Whether a joint has this row at all.
bool has_row(const Joint& joint, int part);
/// Of the numbers of a measure those that belong to the row.
const Vec3& numbers_of(const JointMeasure& measure, int part);

/// The slopes of a lock's lines, which the step keeps: k dt^2 with k for the mass that each of them feels.
/// @param masses     of the three lines [kg, kg m^2]; 0 where nothing moves
/// @param stiffness  k dt^2 / m
void set_lock(const Joint& joint, int part, const Vec3& masses, double stiffness, ElementLaw& law);
/// A spring with a damper is the first line of a drive, a motor the second, both along the free axis.
/// @param coordinate  where the step begins [m, rad]
/// @param left        until the end of the whole step [s]; a motor is at its target then
void set_drive(const JointDrive& drive, double mass, double coordinate, double dt, double left,
               ElementLaw& law);

/// Lets a lock's lines aim at no error where the step ends, through what acts.
/// @param numbers   of the joint at the predicted end
/// @param acting, velocity  impulse on A, and velocity that the row sees now
void follow_lock(const Joint& joint, const Vec3& numbers, const Vec3& acting, const Vec3& velocity, double dt,
                 ElementLaw& law);
/// A spring pushes by its stretch at the end of the step, a damper by the velocity of the step.
void follow_spring(const Joint& joint, const Vec3& numbers, const Vec3& velocity, double dt, ElementLaw& law);
/// One line aims at no error.
void aim(LineLaw& line, double error, double acting, double velocity, double dt);

/// The speed with which a motor goes towards its target in a step: the fastest from which it can still stop
/// there [m/s, rad/s].
/// @param mass  that it moves [kg, kg m^2], positive
double speed_to_target(const JointDrive& drive, double mass, double coordinate, double dt);

/// The speed with which a coordinate leaves a limit that it has struck in this step [m/s, rad/s]: negative
/// from the upper one, 0 where there is no bounce.
/// @param rate    of the coordinate before it met the limit [m/s, rad/s]
/// @param acting  what the limit pushed [N, N m]
/// @param least   the slowest meeting that bounces
double rebound_of(const JointDrive& drive, double rate, double acting, double least);

}  // namespace enduring
