#pragma once

#include "common/fem/linear_solver.hpp"

#include <Eigen/SparseCholesky>

namespace enduring {

/// Eigen's factor. It would look up where each entry stands in the new order at every factorisation: here
/// once.
class OrderedCholesky : public Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> {
public:
    void analyze(Eigen::SparseMatrix<double> pattern)
    {
        analyzePattern(pattern);
        pattern.coeffs().setLinSpaced(0, static_cast<double>(pattern.nonZeros() - 1));
        ordered_.resize(pattern.rows(), pattern.cols());
        ordered_.selfadjointView<Eigen::Upper>() = pattern.selfadjointView<Eigen::Lower>().twistedBy(m_P);
        entry_of_ = ordered_.coeffs().cast<Eigen::Index>();
    }
    double operations() const { return m_nonZerosPerCol.cast<double>().array().square().sum(); }
    void factor(const Eigen::SparseMatrix<double>& matrix)
    {
        ordered_.coeffs() = matrix.coeffs()(entry_of_);
        factorize_preordered<true>(ordered_);
    }

private:
    Eigen::SparseMatrix<double> ordered_;
    Eigen::ArrayX<Eigen::Index> entry_of_;  ///< of each ordered one: its place in the matrix
};

//! [simplicial_solver]
/// The plain linear solver: A = L D L^T.
class SimplicialSolver : public LinearSolver {
public:
    explicit SimplicialSolver(const Eigen::SparseMatrix<double>& pattern) { cholesky_.analyze(pattern); }

    bool factor(const Eigen::SparseMatrix<double>& matrix) override
    {
        cholesky_.factor(matrix);
        return cholesky_.info() == Eigen::Success && (cholesky_.vectorD().array() > 0).all();
    }
    void solve(Eigen::VectorXd& b) const override { b = cholesky_.solve(b).eval(); }
    void solve(Eigen::MatrixXd& b) const override { b = cholesky_.solve(b).eval(); }
    double operations() const override { return cholesky_.operations(); }

private:
    OrderedCholesky cholesky_;
};
//! [simplicial_solver]

}  // namespace enduring
