#pragma once

#include "chapters/07_implicit_contact/pair_law.hpp"

namespace enduring {

/// The point of the friction cone that is nearest to an impulse. The cone contains every impulse that pushes
/// along the normal, and whose part along the surface is at most mu times this push.
///
/// @param wanted  any impulse on p [N s]
/// @param normal  unit length, the axis of the cone
/// @param mu      coefficient of friction, 0 or more
Vec3 nearest_in_cone(const Vec3& wanted, const Vec3& normal, double mu);

/// Derivative of `nearest_in_cone` with respect to `wanted`: symmetric, with eigenvalues from 0 to 1. On a
/// border between two regions, where the derivative does not exist, that of either region.
Mat3 cone_derivative(const Vec3& wanted, const Vec3& normal, double mu);

struct ConvexAnswer {
    Vec3 impulse;      ///< on p, normal and friction together [N s]
    Mat3 hessian;      ///< minus the derivative of the impulse with respect to the velocity [kg]
    double potential;  ///< convex; the impulse is minus its slope with respect to the velocity [J]
};

/// The impulse of a pair in which one spring gives normal impulse and friction, projected onto the cone. The
/// spring is stretched from p's anchor to the position of p at the end of the step:
///   wanted = -k dt (depth_t0 normal + stretch + dt velocity).
/// @param pair  its `lagged_normal_impulse` is not used
ConvexAnswer convex_answer(const PairLaw& pair, const Vec3& velocity, double dt);

/// The depth [m], negative inside, at which such a pair slides along the surface with a constant velocity,
/// under a load and with its friction at the limit. Its `stretch` comes from the friction of the previous
/// step: -k dt stretch is the friction impulse.
/// @param load       [N], of one pair
/// @param stiffness  k [N/m]
/// @param speed      along the surface [m/s], above 0
double depth_of_sliding(double load, double stiffness, double mu, double speed, double dt);

}  // namespace enduring
