#pragma once

#include "common/experiments/report/table.hpp"
#include "common/fem/elastic_body.hpp"

namespace enduring::verification {

/// Moments of inertia about the centre, of a mass matrix with its nodes at these places [kg m^2].
Mat3 inertia(const Eigen::SparseMatrix<double>& masses, const NodalVectors& positions);

/// Moments of inertia over the integral over the volume: of the mass matrix, and of its row sums as point
/// masses at the nodes, about the axes of bars of the scenes, of finer ones, and of the bunny. Columns shape,
/// basis, lumped_x, lumped_y, lumped_z, consistent (the one that differs most from 1).
Table inertia_ratios();

/// The first of these for the bar of 3 x 0.4 x 0.4 m over the cells across it:
/// rows cells_across, linear, quadratic, consistent.
Table inertia_over_cells();

}  // namespace enduring::verification
