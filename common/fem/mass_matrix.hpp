#pragma once

#include "common/fem/elastic_mesh.hpp"

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace enduring {

/// Mean over an element of the product of the basis functions of two of its nodes: the share that this pair
/// has in the element's mass. Positive, for the functions are; the shares of all pairs sum to 1.
double mass_share(Basis basis, int i, int j);

/// The consistent mass matrix, M_ij = density int phi_i phi_j dV [kg], symmetric, one row a node and both
/// triangles stored. For velocities v that vary as the basis says it holds the exact kinetic energy, sum_ij
/// M_ij v_i.v_j / 2, and the exact angular momentum, sum_ij M_ij x_i x v_j. It is the same along every axis,
/// so it commutes with a rotation of the body.
Eigen::SparseMatrix<double> mass_matrix(const ElasticMesh& mesh, double density);

/// The rows' sums [kg], all positive: density times the integral of the node's basis function, V/4 of an
/// element a node for linear elements and V/10 for quadratic ones in Bernstein form. They give the exact
/// mass, centre, weight and linear momentum. As point masses at the nodes they turn too slowly: the nodes lie
/// on the outside of their elements.
Eigen::VectorXd lumped_masses(const Eigen::SparseMatrix<double>& mass_matrix);

}  // namespace enduring
