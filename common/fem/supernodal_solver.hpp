#pragma once

#include "common/fem/linear_solver.hpp"

#include <cholmod.h>

#include <vector>

namespace enduring {

/// The fast linear solver: CHOLMOD's supernodal factor A = P^T L L^T P, applied in single or double
/// precision.
///
/// Nested dissection orders the unknowns: it cuts the body in two by few nodes, which come last, and each
/// half again. Neighbouring columns of L whose entries then stand in the same rows make a dense block (a
/// supernode), and dense blocks are what the BLAS is fast at. A solve reads the factor twice and computes
/// little, so it takes as long as the reading does: in single precision, with half the bytes, it is about
/// twice as fast as CHOLMOD's own. Its relative error is then around 1e-6 (more where the matrix is worse
/// conditioned): far less than a preconditioner may have.
/// @tparam Real  float or double: how the factor is kept and applied
template <class Real>
class SupernodalSolver : public LinearSolver {
public:
    /// @param dissects  whether nested dissection is tried beside minimum degree, which takes longer: for a
    ///     pattern that stays
    SupernodalSolver(const Eigen::SparseMatrix<double>& pattern, bool dissects);
    ~SupernodalSolver() override;
    SupernodalSolver(const SupernodalSolver&) = delete;
    SupernodalSolver& operator=(const SupernodalSolver&) = delete;

    bool factor(const Eigen::SparseMatrix<double>& matrix) override;
    void solve(Eigen::VectorXd& b) const override;
    void solve(Eigen::MatrixXd& b) const override;
    double operations() const override { return operations_; }

private:
    /// Neighbouring columns of L as one dense block: a triangle, and what is below it.
    struct Supernode {
        Eigen::Index first, columns;
        std::vector<int> rows_below;
        Eigen::MatrixX<Real> block;
    };

    void copy_supernodes();
    template <class Floats>
    void solve_ordered(Floats& x) const;

    cholmod_common cholmod_;
    cholmod_factor* factor_ = nullptr;
    double operations_ = 0;
    std::vector<int> order_;  ///< order_[i] is the unknown that comes i-th
    std::vector<Supernode> supernodes_;
};

}  // namespace enduring
