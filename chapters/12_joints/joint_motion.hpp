#pragma once

#include "chapters/07_implicit_contact/step_problem.hpp"
#include "common/simulation/joint.hpp"

#include <array>
#include <vector>

namespace enduring {

/// How the velocity that a row sees follows from the coordinates of the bodies that answer forces, and what
/// those that move as given add.
struct RowMotion {
    std::vector<VertexMotion> parts;
    Vec3 given = Vec3::Zero();  ///< mean of the step [m/s, rad/s]
};

/// Of A's point against the point of B in the same place, but for a distance, which has two points; or of the
/// turn.
/// @param pose  at the start of the step
/// @param part  see JointPart
RowMotion motion_of_row(const World& world, const StepProblem& step, const Joint& joint,
                        const JointPose& pose, int part);
/// The first number is the turn rate of a gear's second hinge, less its ratio times that of the first; the
/// others are zero.
RowMotion motion_of_gear(const World& world, const StepProblem& step, const Joint& joint);

/// What a joint reads of soft bodies: the vertices of the faces that it holds, those of B with negative
/// weights.
std::vector<VertexShare> soft_shares(const Joint& joint);

/// Whether a joint holds: one that is broken does not, nor a gear of which a hinge is broken.
bool holds(const World& world, const Joint& joint);
/// By how much the turns of a gear's hinges miss its ratio at the predicted end of a step [rad].
double gear_error(const World& world, const Joint& joint, double dt);
/// The same where the world stands.
double gear_error(const World& world, const Joint& joint);
/// Axis of a gear's second hinge, unit length.
Vec3 gear_axis(const World& world, const Joint& joint);

/// What one end of a joint does in a step, by the levers of its start.
struct EndRates {
    Vec3 along = Vec3::Zero();  ///< of its point [m/s]
    Vec3 about = Vec3::Zero();  ///< [rad/s]
};
/// As its body moves now; of one that moves as given the mean of the step of dt.
/// @param point  in the world [m]
EndRates end_rates(const World& world, const JointEnd& end, const Vec3& point, double dt);

}  // namespace enduring
