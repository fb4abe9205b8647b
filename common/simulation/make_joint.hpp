#pragma once

#include "common/simulation/joint.hpp"

#include <string>

namespace enduring {

struct World;

/// Axes at right angles in the columns, the third as given.
/// @param third  unit length
Mat3 axes_about(const Vec3& third);

/// Whether a body is soft; false for -1, the world.
bool is_soft(const World& world, int body);

/// The point [m] itself; of a soft body the point of its surface that is nearest to it.
Vec3 held_point(const World& world, int body, const Vec3& point);

/// The end of a joint at a body of the world, as it lies now; the world itself for -1 and on a body that
/// stands. On a soft body it is held_point().
/// @param point  in the world [m]
/// @param axes   of the joint in the world
JointEnd joint_end(const World& world, int body, const Vec3& point, const Mat3& axes);

/// A joint that holds its bodies as they lie now, without limits, motor and spring. Of a soft body it may be
/// a ball.
/// @param a     index of the body that moves
/// @param b     index of the other one, -1 for the world
/// @param at    in the world [m]
/// @param axes  of the joint in the world: the third one is its axis; of a universal joint the first is A's,
///     the second B's
Joint make_joint(const World& world, std::string name, JointKind kind, int a, int b, const Vec3& at,
                 const Mat3& axes = Mat3::Identity());

/// A rod between a point of A and another one of B; give its `way` other limits for a rope, or a spring.
/// @param at, to  in the world [m], not the same
Joint make_rod(const World& world, std::string name, int a, int b, const Vec3& at, const Vec3& to);

/// A gear: the second hinge turns `ratio` times as far as the first, both counted from where they began.
/// @param first, second  places of two hinges in World::joints; each of them has a body that answers forces
Joint make_gear(std::string name, const World& world, int first, int second, double ratio);

}  // namespace enduring
