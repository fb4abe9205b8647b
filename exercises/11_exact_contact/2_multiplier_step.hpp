#pragma once

#include "common/geometry/vector.hpp"

namespace enduring {

/// A block over the ground, and its spring. The first number of each vector is along the normal.
struct BlockOnSpring {
    double mass;         ///< [kg]
    double stiffness;    ///< k, along the normal and along the surface [N/m]
    double dt;           ///< [s]
    double mu;           ///< coefficient of friction
    Vec3 free_velocity;  ///< q: its velocity after the step without contact [m/s]
};

/// One solve: the impulse that the spring gives if it begins the step pressed in by `begin` [m], rest offset
/// first, then stretch. It pushes with k (begin - dt u), where u is the velocity after the step. It does not
/// pull, and friction is cut to mu r_n [N s].
Vec3 impulse_of_spring(const BlockOnSpring& block, const Vec3& begin);

/// How far the spring begins the next solve pressed in, if it pushed this impulse [m].
Vec3 next_begin(const BlockOnSpring& block, const Vec3& impulse);

/// The impulse after some passes. The first pass begins with a spring that is not pressed in; no pass gives
/// no impulse.
Vec3 impulse_after(const BlockOnSpring& block, int passes);

/// The same without a solve: what the exact impulse of the block becomes after so many passes.
Vec3 predicted_impulse(const BlockOnSpring& block, const Vec3& exact, int passes);

}  // namespace enduring
