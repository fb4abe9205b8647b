#pragma once

#include "common/geometry/vector.hpp"

namespace enduring {

/// The law from a pair's motion to its impulse in one step. Its normal is constant.
struct PairLaw {
    Vec3 normal = Vec3::UnitY();  ///< unit length, out of B
    double depth_t0 = 0;          ///< at the start of the step, from its rest offset [m]
    double stiffness = 0;         ///< k, along the normal and along the surface [N/m]
    Vec3 stretch = Vec3::Zero();  ///< of its friction at the start of the step, along the surface [m]
    double mu = 0;                ///< coefficient of friction
    /// The normal impulse from which friction's limit follows [N s], that of an earlier motion. It is known,
    /// so the impulse is the gradient of a convex potential of the velocity. With the normal impulse of the
    /// same motion there is no potential.
    double lagged_normal_impulse = 0;
    double viscous = 0;  ///< of a film between the surfaces, see viscous_friction.hpp [s/m]
    /// of a surface with a grain, from a velocity along the surface to the one that an equal friction in all
    /// directions would feel
    Mat3 grain = Mat3::Identity();
    bool has_grain = false;
};

/// The same for all pairs.
struct StepLaw {
    double centre = 1;  ///< of the weight over the step, in [1/2, 1]
    double dt = 0.01;   ///< [s]
};

/// The impulse of a pair, and what its derivative needs.
struct PairPush {
    Vec3 normal_impulse, friction = Vec3::Zero();  ///< on p [N s]
    double slope = 0;  ///< of the normal impulse over the depth at the end [N s/m]
    double limit = 0;  ///< of friction [N s]
    /// the impulse of friction's spring without its limit, where there is one; on a grain the one that an
    /// equal friction would have [N s]
    Vec3 spring = Vec3::Zero();
    bool slips = false;

    Vec3 total() const { return normal_impulse + friction; }
};

/// The impulse of the spring along the surface without a limit, see PairPush::spring [N s].
Vec3 spring_impulse(const PairLaw& pair, const Vec3& velocity, const StepLaw& step);

/// The normal impulse, which does not depend on the limit of friction [N s]; never negative.
double normal_impulse(const PairLaw& pair, const Vec3& velocity, const StepLaw& step);

/// @param velocity  of p against q over the step [m/s]
PairPush pushed(const PairLaw& pair, const Vec3& velocity, const StepLaw& step);
/// Minus the derivative of what a pair pushes by the velocity [kg]; symmetric, never negative.
Mat3 hessian_of(const PairLaw& pair, const PairPush& push, const StepLaw& step);

}  // namespace enduring
