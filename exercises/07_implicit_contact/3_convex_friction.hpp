#pragma once

#include "chapters/07_implicit_contact/pair_law.hpp"

namespace enduring {

/// The point of the friction cone that is nearest to an impulse. The cone holds every impulse that pushes
/// along the normal and is at most mu times as large along the surface.
///
/// @param wanted  any impulse on p [N s]
/// @param normal  unit length, the axis of the cone
/// @param mu      coefficient of friction, 0 or more
Vec3 nearest_in_cone(const Vec3& wanted, const Vec3& normal, double mu);

/// Derivative of `nearest_in_cone` by `wanted`: symmetric, with eigenvalues from 0 to 1. On a border between
/// two regions, where there is none, that of one of them.
Mat3 cone_derivative(const Vec3& wanted, const Vec3& normal, double mu);

struct ConvexAnswer {
    Vec3 impulse;      ///< on p, normal and friction together [N s]
    Mat3 hessian;      ///< minus its derivative by the velocity [kg]
    double potential;  ///< convex, and minus its slope by the velocity is the impulse [J]
};

/// What a pair answers whose normal impulse and friction are one spring, cut to the cone. The spring is
/// stretched from p's anchor to where p ends the step:
///   wanted = -k dt (depth_t0 normal + stretch + dt velocity).
/// @param pair  its `lagged_normal_impulse` is not used
ConvexAnswer convex_answer(const PairLaw& pair, const Vec3& velocity, double dt);

/// The depth, negative inside, at which such a pair slides with a constant velocity along the surface, while
/// a load presses it and its friction is at the limit [m]. Its `stretch` is what this friction held in the
/// step before: -k dt stretch is the friction impulse.
/// @param load       [N], of one pair
/// @param stiffness  k [N/m]
/// @param speed      along the surface [m/s], above 0
double depth_of_sliding(double load, double stiffness, double mu, double speed, double dt);

}  // namespace enduring
