#pragma once

#include "chapters/12_joints/joint_motion.hpp"
#include "common/simulation/step.hpp"

#include <array>
#include <vector>

namespace enduring {

/// What both ends of a joint do at one moment of a step, A's first. A gear's first end has its hinges' turns
/// against its ratio, about gear_axis().
using JointRates = std::array<EndRates, 2>;
std::vector<JointRates> joint_rates(const World& world, double dt);

/// Before the step becomes the state: books what joints have done to energy. The work of motors counts as
/// driven, and so does that of bodies that move as given. Locks do none; what the leapfrog of the step makes
/// of their impulses on rigid bodies it takes back within a swing, so the watch on energy does not count it,
/// nor what the leapfrog makes of a weight that pairs carry.
/// Notes which limits were struck, and by what.
/// @param before  the rates without contact and joints in this step
void book_joints(World& world, const Contacts& contacts, const std::vector<JointRates>& before, double dt);

/// When a step is the state: turns are counted on, and what carries more than it bears breaks.
void end_joints(World& world);

}  // namespace enduring
