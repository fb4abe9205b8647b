#include "common/fem/linear_solver.hpp"

#include "common/fem/exact_solver.hpp"
#include "common/fem/simplicial_solver.hpp"
#ifdef ENDURING_CHOLMOD
#include "common/fem/supernodal_solver.hpp"
#endif

namespace enduring {

std::unique_ptr<LinearSolver> make_linear_solver([[maybe_unused]] LinearSolverKind kind,
                                                 const Eigen::SparseMatrix<double>& pattern)
{
#ifdef ENDURING_CHOLMOD
    if (kind == LinearSolverKind::supernodal)
        return std::make_unique<SupernodalSolver<float>>(pattern, true);
#endif
    return std::make_unique<SimplicialSolver>(pattern);
}

std::unique_ptr<LinearSolver> make_exact_solver(const Eigen::SparseMatrix<double>& pattern)
{
#ifdef ENDURING_CHOLMOD
    return std::make_unique<SupernodalSolver<double>>(pattern, false);
#else
    return std::make_unique<SimplicialSolver>(pattern);
#endif
}

bool has_supernodal_solver()
{
#ifdef ENDURING_CHOLMOD
    return true;
#else
    return false;
#endif
}

}  // namespace enduring
