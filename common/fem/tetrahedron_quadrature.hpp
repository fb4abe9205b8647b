#pragma once

#include <Eigen/Core>

#include <vector>

namespace enduring {

/// A point of a quadrature rule on a tetrahedron.
struct QuadraturePoint {
    Eigen::Vector4d barycentric;
    double weight;  ///< share of the volume; the weights sum to 1
};

/// 14 points, exact for polynomials up to degree 5 (Walkington 2000).
const std::vector<QuadraturePoint>& degree_five_quadrature();

}  // namespace enduring
