#pragma once

#include "common/geometry/vector.hpp"

namespace enduring {

/// A block above the ground, and its spring. The first number of each vector is along the normal.
struct BlockOnSpring {
    double mass;         ///< [kg]
    double stiffness;    ///< k, along the normal and along the surface [N/m]
    double dt;           ///< [s]
    double mu;           ///< coefficient of friction
    Vec3 free_velocity;  ///< q: its velocity after the step without contact [m/s]
};

/// One solve: the impulse of the spring [N s] if it begins the step with the compression `begin` [m] (first
/// the rest offset, then the stretch). Its force is k (begin - dt u), where u is the velocity after the step.
/// The spring does not pull, and friction is cut to mu r_n.
Vec3 impulse_of_spring(const BlockOnSpring& block, const Vec3& begin);

/// The compression with which the spring begins the next solve after this impulse [m].
Vec3 next_begin(const BlockOnSpring& block, const Vec3& impulse);

/// The impulse after some passes. The first pass begins with an uncompressed spring; zero passes give no
/// impulse.
Vec3 impulse_after(const BlockOnSpring& block, int passes);

/// The same without a solve: the impulse after this number of passes, from the exact impulse.
Vec3 predicted_impulse(const BlockOnSpring& block, const Vec3& exact, int passes);

}  // namespace enduring
