#pragma once

#include "common/fem/linear_solver.hpp"

#include <Eigen/SparseCholesky>

namespace enduring {

//! [simplicial_solver]
/// The plain linear solver: A = L D L^T.
class SimplicialSolver : public LinearSolver {
public:
    explicit SimplicialSolver(const Eigen::SparseMatrix<double>& pattern)
    {
        cholesky_.analyzePattern(pattern);
    }

    bool factor(const Eigen::SparseMatrix<double>& matrix) override
    {
        cholesky_.factorize(matrix);
        return cholesky_.info() == Eigen::Success && (cholesky_.vectorD().array() > 0).all();
    }
    void solve(Eigen::VectorXd& b) const override { b = cholesky_.solve(b).eval(); }
    void solve(Eigen::MatrixXd& b) const override { b = cholesky_.solve(b).eval(); }

private:
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> cholesky_;
};
//! [simplicial_solver]

}  // namespace enduring
