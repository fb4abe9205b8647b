#pragma once

#include "common/simulation/joint.hpp"

#include <string>

namespace enduring {

struct World;

/// Axes at right angles in the columns, the third as given.
/// @param third  unit length
Mat3 axes_about(const Vec3& third);

/// The end of a joint at a body of the world, as it lies now; the world itself for -1 and on a body that stands.
/// @param point  in the world [m]
/// @param axes   of the joint in the world
JointEnd joint_end(const World& world, int body, const Vec3& point, const Mat3& axes);

/// A joint that holds its bodies as they lie now, without limits, motor and spring.
/// @param a     index of the body that moves
/// @param b     index of the other one, -1 for the world
/// @param at    in the world [m]
/// @param axes  of the joint in the world: the third one is its axis; of a universal joint the first is A's, the second B's
Joint make_joint(const World& world, std::string name, JointKind kind, int a, int b, const Vec3& at,
                 const Mat3& axes = Mat3::Identity());

/// A rod between a point of A and another one of B; give its `way` other limits for a rope, or a spring.
/// @param at, to  in the world [m], not the same
Joint make_rod(const World& world, std::string name, int a, int b, const Vec3& at, const Vec3& to);

}  // namespace enduring
