#pragma once

#include "common/geometry/vector.hpp"

#include <Eigen/Core>

#include <array>

namespace enduring {

using Vector12 = Eigen::Matrix<double, 12, 1>;
using Matrix12 = Eigen::Matrix<double, 12, 12>;
/// The corners of two features: a point and a triangle, or two edges one behind the other [m].
using FourPoints = std::array<Vec3, 4>;

/// A number that depends on four points, with its derivatives by their twelve coordinates.
struct Derivatives {
    double value = 0;
    Vector12 gradient = Vector12::Zero();
    Matrix12 hessian = Matrix12::Zero();
};

//! [nearest_points]
/// The nearest points of two features. p - q = sum_i weights[i] x[i]: positive weights are those of the first
/// feature, with sum 1, negative ones those of the second, with sum -1; exactly 0 for corners that have no
/// part. So the signs tell which case it is: point-point, point-edge, point-triangle or edge-edge.
struct NearestPoints {
    std::array<double, 4> weights{};
    Vec3 difference = Vec3::Zero();  ///< p - q [m]
};
/// @param x  the point, and the triangle's corners
NearestPoints nearest_of_point_triangle(const FourPoints& x);
/// Nearly parallel edges have them at an end. @param x  the ends of the one edge, and of the other
NearestPoints nearest_of_edges(const FourPoints& x);
//! [nearest_points]

/// The squared distance [m^2] of two features as a function of their corners, as long as the case stays.
///
/// It is the minimum of |sum_i w_i(beta) x_i|^2 over the places beta along the features. So its gradient is
/// that at the nearest points, and its Hessian is a Schur complement, H_xx - H_xb H_bb^-1 H_bx: one formula
/// for all cases.
/// @param nearest  of these corners
/// @see Li et al. 2020, "Incremental potential contact", section on distances: the cases
Derivatives squared_distance(const FourPoints& x, const NearestPoints& nearest);

/// From 0 at parallel edges to 1: -c^2 / e^2 + 2 c / e below c = e, with c the squared length of the edges'
/// cross product. Times the barrier, it makes forces smooth where nearest points jump from end to end.
/// @param x      the ends of the one edge, and of the other
/// @param least  e [m^4], positive: from here on it is 1
/// @see Li et al. 2020, section on edges that are nearly parallel
Derivatives edge_mollifier(const FourPoints& x, double least);

}  // namespace enduring
