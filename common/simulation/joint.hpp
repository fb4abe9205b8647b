#pragma once

#include "common/geometry/vector.hpp"
#include "common/rigid/rigid_motion.hpp"
#include "common/simulation/state_archive.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace enduring {

struct World;

/// What a joint leaves free between its bodies A and B. The third axis of the frame on B is the joint's axis.
///   ball       all turns
///   hinge      the turn about the axis
///   slider     the way along the axis
///   cylinder   both of these
///   universal  turns about the first axis of A's frame and the second of B's, which stay at
///              right angles (Cardan's joint)
///   fixed      nothing
///   distance   all but the length between its two points, which is its way: a rod, a rope, a spring
///   gear       all but that the turns of two hinges keep a ratio
enum class JointKind : std::uint8_t { ball, hinge, slider, cylinder, universal, fixed, distance, gear };

/// Where a joint holds a body. Without a body, or on one that stands, it is the world. On a soft body it is a
/// point of a face of its surface, which moves with the face's vertices and has no axes of its own: a joint
/// there may lock ways, and no turns.
struct JointEnd {
    int body = -1;  ///< index into World::bodies, -1 for the world
    Vec3 point =
        Vec3::Zero();  ///< in the coordinates of the body's pose, or in the world [m]; unused on a soft body
    Quaternion frame =
        Quaternion::Identity();               ///< from the joint's axes to those of the body, or of the world
    std::array<int, 3> vertices{-1, -1, -1};  ///< of a soft body
    Vec3 weights = Vec3::Zero();              ///< of these, together 1

    bool is_soft() const { return vertices[0] >= 0; }
};

/// What limits, drives or springs do with one free coordinate: a way [m, N] or a turn [rad, N m].
struct JointDrive {
    double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
    double bounce = 0;  ///< coefficient of restitution at both limits, from 0 to 1
    double motor_speed =
        0;  ///< that the motor wants [m/s, rad/s]; with a target, the fastest that it goes there
    double motor_most = 0;                 ///< the most that it pushes [N, N m]; 0 for no motor
    std::optional<double> motor_target{};  ///< where the motor wants to stand [m, rad]
    double stiffness = 0;                  ///< of a spring [N/m, N m/rad]
    double damping = 0;                    ///< [N s/m, N m s/rad]
    double rest = 0;                       ///< where the spring pushes nothing [m, rad]

    bool pushes() const { return motor_most > 0 || stiffness > 0 || damping > 0; }
    /// Of what a motor of this strength or a spring stretched by its coordinate pushes, whichever is more [N,
    /// N m].
    double most(double coordinate) const
    {
        return std::max(motor_most, stiffness * std::abs(coordinate - rest));
    }
};

/// Two bodies, or a body and the world, and what is left free between them. All that lasts from step to step
/// stands here.
struct Joint {
    std::string name;
    JointKind kind = JointKind::ball;
    JointEnd a, b;
    JointDrive way, turn;
    std::array<int, 2> hinges{-1, -1};  ///< of a gear: two hinges by their places in World::joints
    double ratio =
        1;  ///< of a gear: turn of the second hinge over that of the first; negative for teeth that mesh
    double breaks_at = std::numeric_limits<double>::infinity();  ///< force at which it gives way for good [N]
    bool bodies_touch = false;  ///< whether its two bodies push each other as others do

    // state
    bool broken = false;
    bool acts = false;                                           ///< its force acts in this step already
    Vec3 lock_force = Vec3::Zero(), lock_torque = Vec3::Zero();  ///< on A, along its axes [N, N m]
    double way_force = 0, turn_torque = 0;                       ///< of its springs and motors [N, N m]
    double way_rebound = 0,
           turn_rebound = 0;  ///< speed with which it leaves a limit that it has struck [m/s, rad/s]
    double angle = 0;         ///< about the axis, whole turns counted [rad]
    Vec3 force = Vec3::Zero(),
         torque = Vec3::Zero();  ///< all of it on A, in world axes [N, N m]; torque about the joint's point
};

/// Writes or reads what changes from step to step.
void visit_state(StateArchive& archive, Joint& joint);

/// Where both ends of a joint are.
struct JointPose {
    Vec3 point_a = Vec3::Zero(), point_b = Vec3::Zero();        ///< in the world [m]
    Mat3 axes_a = Mat3::Identity(), axes_b = Mat3::Identity();  ///< in the columns
};
JointPose committed_pose(const World& world, const Joint& joint);
/// At the end of the step as it is predicted.
JointPose predicted_pose(const World& world, const Joint& joint, double dt);

/// Directions in the columns along which a joint measures how far its ends are apart, and about which it
/// measures how far they are turned; zero where it measures nothing.
struct JointAxes {
    Mat3 along = Mat3::Zero(), about = Mat3::Zero();
};
JointAxes joint_axes(JointKind kind, const JointPose& pose);

/// The numbers that belong to these directions: zero where the joint locks, the way and the turn where it
/// does not.
struct JointMeasure {
    Vec3 along = Vec3::Zero();  ///< [m]
    Vec3 about = Vec3::Zero();  ///< [rad]
};
/// @param angle  about the axis, a little before: the turn is counted on from it
JointMeasure joint_measure(JointKind kind, const JointPose& pose, double angle);

/// Which of these numbers is free; -1 where none is.
int free_way(JointKind kind);
int free_turn(JointKind kind);
/// Whether it reads no turn of its two ends against each other: of a soft body's point there is none.
bool leaves_turns(JointKind kind);
/// Whether it locks one of them.
bool locks_along(JointKind kind, int place);
bool locks_about(JointKind kind, int place);

/// Length of the way, or turn, where a joint has one [m, rad].
double way_of(const World& world, const Joint& joint);
double turn_of(const World& world, const Joint& joint);
/// What the springs of all joints hold in the committed state [J].
double joint_energy(const World& world);
/// Whether two bodies are held together by a joint whose bodies do not touch.
bool are_joined(const std::vector<Joint>& joints, int body, int other);

}  // namespace enduring
