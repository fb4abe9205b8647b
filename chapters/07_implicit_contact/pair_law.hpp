#pragma once

#include "common/geometry/vector.hpp"

namespace enduring {

/// What decides what a pair answers to its motion in one step. Its normal stands still.
struct PairLaw {
    Vec3 normal = Vec3::UnitY();  ///< unit length, out of B
    double depth_t0 = 0;          ///< at the start of the step, from where its spring is slack [m]
    double stiffness = 0;         ///< k, along the normal and along the surface [N/m]
    Vec3 stretch = Vec3::Zero();  ///< of its friction at the start of the step, along the surface [m]
    double mu = 0;                ///< coefficient of friction
    /// The normal impulse that friction's limit is taken from [N s]. It is that of an earlier motion, so it is known: then the
    /// impulse is the slope of a convex potential of the velocity. With the normal impulse of the same motion there is none.
    double lagged_normal_impulse = 0;
};

/// What all pairs share.
struct StepLaw {
    double centre = 1;  ///< of the weight over the step, in [1/2, 1]
    double dt = 0.01;   ///< [s]
};

/// What a pair pushes, and what the derivative needs besides.
struct PairPush {
    Vec3 normal_impulse, friction = Vec3::Zero();  ///< on p [N s]
    double slope = 0;  ///< of the normal impulse over the depth at the end [N s/m]
    double limit = 0;  ///< of friction [N s]
    Vec3 spring =
        Vec3::Zero();  ///< what friction's spring would push if it never gave, where there is a limit [N s]
    bool slips = false;

    Vec3 total() const { return normal_impulse + friction; }
};

/// What the spring along the surface would push if it never gave [N s].
Vec3 spring_impulse(const PairLaw& pair, const Vec3& velocity, const StepLaw& step);

/// What the normal pushes, which does not ask for a limit [N s]; never negative.
double normal_impulse(const PairLaw& pair, const Vec3& velocity, const StepLaw& step);

/// @param velocity  of p against q over the step [m/s]
PairPush pushed(const PairLaw& pair, const Vec3& velocity, const StepLaw& step);
/// Minus the derivative of what a pair pushes by the velocity [kg]; symmetric, never negative.
Mat3 hessian_of(const PairLaw& pair, const PairPush& push, const StepLaw& step);

}  // namespace enduring
