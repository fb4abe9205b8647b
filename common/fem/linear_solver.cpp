#include "common/fem/linear_solver.hpp"

#include "common/fem/simplicial_solver.hpp"
#include "common/fem/supernodal_solver.hpp"

namespace enduring {

std::unique_ptr<LinearSolver> make_linear_solver(LinearSolverKind kind,
                                                 const Eigen::SparseMatrix<double>& pattern)
{
    if (kind == LinearSolverKind::simplicial)
        return std::make_unique<SimplicialSolver>(pattern);
    return std::make_unique<SupernodalSolver>(pattern);
}

}  // namespace enduring
