#pragma once

#include "common/fem/linear_solver.hpp"

namespace enduring {

/// For large matrices whose pattern changes often: CHOLMOD's factor, ordered by minimum degree and applied in
/// double precision; the simplicial solver where this was built without CHOLMOD.
/// @param pattern  lower triangle of the matrices to come; only where its entries are counts
std::unique_ptr<LinearSolver> make_exact_solver(const Eigen::SparseMatrix<double>& pattern);

}  // namespace enduring
