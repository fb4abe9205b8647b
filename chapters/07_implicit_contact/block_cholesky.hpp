#pragma once

#include "common/fem/linear_solver.hpp"

#include <span>
#include <vector>

namespace enduring {

/// A = L L^T of rigid bodies in contact: unknowns come in sixes, and entries in blocks of 6 x 6. Each is one
/// small matrix, whose loops the compiler unrolls.
class BlockCholesky : public LinearSolver {
public:
    static constexpr int side = 6;
    using Block = Eigen::Matrix<double, side, side>;

    /// @param pattern  lower triangle of the matrices to come; the columns of six unknowns have the same
    /// rows,
    ///     above the diagonal of their own block too
    explicit BlockCholesky(const Eigen::SparseMatrix<double>& pattern);

    bool factor(const Eigen::SparseMatrix<double>& matrix) override;
    void solve(Eigen::VectorXd& b) const override;
    void solve(Eigen::MatrixXd& b) const override;
    double operations() const override;

private:
    /// A block of A: its first entry among those of the matrix, its place among the blocks of L, and whether
    /// it lies on the other side of the diagonal there.
    struct Source {
        Eigen::Index entry, stride;
        std::size_t place;
        bool transposed;
    };
    using Rows = std::vector<std::vector<int>>;  ///< of each column, below the diagonal, ascending

    Rows order_blocks(const Eigen::SparseMatrix<double>& pattern);
    void find_rows(Rows rows);
    void find_sources(const Eigen::SparseMatrix<double>& pattern);
    void find_updates();
    std::size_t place_of(int row, int column) const;
    std::span<const int> rows_of(int column) const;
    bool factor_column(int column);
    template <class Unknowns>
    void solve_ordered(Unknowns& x) const;

    int columns_ = 0;
    std::vector<int> new_place_;      ///< of each six unknowns
    std::vector<std::size_t> first_;  ///< of each column: its first block, on the diagonal; then their number
    std::vector<int> row_;            ///< of each block
    std::vector<Source> sources_;
    std::vector<std::size_t> updated_;  ///< blocks that each column changes, one behind the other
    std::vector<Block> blocks_;         ///< of L
};

}  // namespace enduring
