#pragma once

#include <Eigen/CholmodSupport>
#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace enduring {

/// A sparse Cholesky factorisation that solves in single precision.
///
/// A solve reads the factor twice and computes little, so it takes as long as the reading does. Half the bytes, and dense
/// blocks of columns instead of an index for every entry, make it about twice as fast as CHOLMOD's own. Its relative
/// error is around 1e-6 (more where the matrix is worse conditioned): far less than a preconditioner may have.
class BlockFactor {
public:
    /// Orders the unknowns and finds the factor's sparsity.
    /// @param pattern  lower triangle of the matrices to come
    void analyze(const Eigen::SparseMatrix<double>& pattern);
    /// @param matrix  lower triangle
    /// @return        false if the matrix is not positive definite, or memory ran out
    bool factor(const Eigen::SparseMatrix<double>& matrix);
    /// Replaces b by the solution.
    void solve(Eigen::VectorXd& b) const;

private:
    /// Eigen keeps CHOLMOD's factor to itself.
    struct Cholesky : Eigen::CholmodSimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower> {
        const cholmod_factor& result() const { return *m_cholmodFactor; }
    };
    /// Neighbouring columns whose entries stand in the same rows, as one dense block: a triangle, and what is below it. The
    /// three unknowns of a node always share their rows, and fill-in makes many nodes do so.
    struct Supernode {
        Eigen::Index first, columns;
        std::vector<int> rows_below;
        Eigen::MatrixXf block;
    };

    void append_supernode(const cholmod_factor& factor, int first, int columns);

    Cholesky cholesky_;
    std::vector<int> order_;  ///< order_[i] is the unknown that comes i-th
    std::vector<Supernode> supernodes_;
};

}  // namespace enduring
