#pragma once

#include "common/simulation/step.hpp"

namespace enduring {

/// (omega dt)^2 of the fastest swing that the forces of joints give to a body: a tight chain's link is a
/// string. The direction of a joint's force is that of the start of a step, so the swing is stable below 4.
/// Forces are those of the last step.
double joint_swing(const World& world, double dt);

/// The largest such number with which a step is taken as a whole. A quarter: chains take twice as many parts.
/// Four times: the links of a tight chain begin to shake.
inline constexpr double most_joint_swing = 1;

}  // namespace enduring
