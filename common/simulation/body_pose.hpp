#pragma once

#include "common/rigid/rigid_motion.hpp"
#include "common/simulation/body.hpp"

namespace enduring {

/// Where a body is that keeps its shape: a rigid one, and one that moves as given, whose coordinates are
/// those of its place without the motion. The identity for all others: what is fixed in a standing body is
/// fixed in the world.
Pose committed_pose(const Body& body);
/// At the predicted end of a step of dt [s].
Pose predicted_pose(const Body& body, double dt);
/// The mean rate of the turn that leads from one pose to another in dt [s], by the shorter way [rad/s].
Vec3 mean_turn_rate(const Pose& from, const Pose& to, double dt);
/// The same of a body in a step.
Vec3 mean_turn_rate(const Body& body, double dt);

}  // namespace enduring
