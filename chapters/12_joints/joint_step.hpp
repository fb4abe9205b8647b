#pragma once

#include "common/simulation/step.hpp"

#include <vector>

namespace enduring {

/// What the bodies of a joint do against each other at one moment of a step, by the levers of its start.
struct JointRates {
    Vec3 along = Vec3::Zero();  ///< of A's point against B's [m/s]
    Vec3 about = Vec3::Zero();  ///< [rad/s]
};
std::vector<JointRates> joint_rates(const World& world);

/// Before the step becomes the state: books what joints have done to energy. The work of motors counts as driven. Locks do none; what
/// the leapfrog of the step makes of their impulses it takes back within a swing, so the watch on energy does not count it.
/// @param before  the rates without contact and joints in this step
void book_joints(World& world, const std::vector<JointRates>& before, double dt);

/// When a step is the state: turns are counted on, and what carries more than it bears breaks.
void end_joints(World& world);

}  // namespace enduring
