#pragma once

#include "common/simulation/body.hpp"

#include <optional>

namespace enduring {

/// How a body moves as a whole.
struct WholeMotion {
    double mass = 0;               ///< [kg]
    Vec3 centre = Vec3::Zero();    ///< of mass [m]
    Mat3 inertia = Mat3::Zero();   ///< about it, in world axes [kg m^2]
    Vec3 momentum = Vec3::Zero();  ///< [kg m/s]
    Vec3 spin = Vec3::Zero();      ///< angular momentum about the centre [kg m^2/s]
};

/// Of the committed state of a rigid or a soft body; empty where one is held or given, so that its momentum
/// is not its own.
std::optional<WholeMotion> whole_motion(const Body& body);

/// Between steps: it moves so from now on. A soft body keeps how its parts move against each other.
/// @param body      one that has a whole_motion()
/// @param velocity  of its centre of mass [m/s]
/// @param turn      in world axes [rad/s]
void move_as_a_whole(Body& body, const Vec3& velocity, const Vec3& turn);

}  // namespace enduring
