#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>

namespace enduring {

/// Solves A x = b for a sparse, symmetric, positive definite A, by a factorisation that serves many b.
class LinearSolver {
public:
    virtual ~LinearSolver() = default;

    /// @param matrix  lower triangle of A; its entries stand where those of the pattern do
    /// @return        false if A is not positive definite, or memory ran out
    virtual bool factor(const Eigen::SparseMatrix<double>& matrix) = 0;
    /// Replaces b by A^-1 b, with the A that was factored last.
    virtual void solve(Eigen::VectorXd& b) const = 0;
    /// The same for each column of b, where the factor is read once for all of them.
    virtual void solve(Eigen::MatrixXd& b) const = 0;
    /// Additions and multiplications of a factor; n^3 / 3 for a dense matrix.
    virtual double operations() const = 0;
};

enum class LinearSolverKind {
    simplicial,  ///< Eigen's factor, column by column, in double precision: short, and slow for large bodies
    /// CHOLMOD's factor, block by block, applied in single precision: fast, for a preconditioner
    supernodal,
};

/// Whether this was built with CHOLMOD. Without it every solver is the simplicial one.
bool has_supernodal_solver();

/// Orders the unknowns and finds where the factor has entries.
/// @param pattern  lower triangle of the matrices to come; only where its entries are counts
std::unique_ptr<LinearSolver> make_linear_solver(LinearSolverKind kind,
                                                 const Eigen::SparseMatrix<double>& pattern);

}  // namespace enduring
