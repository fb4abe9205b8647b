#include "common/fem/block_factor.hpp"

#include <utility>

namespace enduring {
namespace {

const int* ints(const void* array) { return static_cast<const int*>(array); }

/// Does this column stand in the same rows as the one before it? It does if that has an entry in the column's own row, for
/// then it has all of the column's rows (fill-in), and one entry more, for then it has no others.
bool continues(const cholmod_factor& factor, int column)
{
    const int before = column - 1;
    return ints(factor.nz)[before] == ints(factor.nz)[column] + 1 && ints(factor.i)[ints(factor.p)[before] + 1] == column;
}

}  // namespace

void BlockFactor::analyze(const Eigen::SparseMatrix<double>& pattern)
{
    cholesky_.cholmod().print = 0;  // factor() says by its result what CHOLMOD would print
    cholesky_.analyzePattern(pattern);
}

bool BlockFactor::factor(const Eigen::SparseMatrix<double>& matrix)
{
    cholesky_.factorize(matrix);
    if (cholesky_.info() != Eigen::Success)
        return false;
    const cholmod_factor& factor = cholesky_.result();
    const int size = static_cast<int>(factor.n);
    order_.assign(ints(factor.Perm), ints(factor.Perm) + size);

    supernodes_.clear();
    for (int first = 0; first < size;) {
        int columns = 1;
        while (first + columns < size && continues(factor, first + columns))
            ++columns;
        append_supernode(factor, first, columns);
        first += columns;
    }
    return true;
}

void BlockFactor::append_supernode(const cholmod_factor& factor, int first, int columns)
{
    const int height = ints(factor.nz)[first];
    const int* rows = ints(factor.i) + ints(factor.p)[first];
    Supernode node{first, columns, {rows + columns, rows + height}, Eigen::MatrixXf::Zero(height, columns)};
    for (int column = 0; column < columns; ++column) {
        const double* entries = static_cast<const double*>(factor.x) + ints(factor.p)[first + column];
        for (int row = column; row < height; ++row)
            node.block(row, column) = static_cast<float>(entries[row - column]);
    }
    supernodes_.push_back(std::move(node));
}

//! [block_solve]
void BlockFactor::solve(Eigen::VectorXd& b) const
{
    Eigen::VectorXf x(b.size()), below(b.size());
    for (Eigen::Index i = 0; i < b.size(); ++i)
        x[i] = static_cast<float>(b[order_[static_cast<std::size_t>(i)]]);

    for (const auto& [first, columns, rows, block] : supernodes_) {
        auto here = x.segment(first, columns);
        block.topRows(columns).triangularView<Eigen::Lower>().solveInPlace(here);
        const auto count = static_cast<Eigen::Index>(rows.size());
        below.head(count).noalias() = block.bottomRows(count) * here;
        for (Eigen::Index i = 0; i < count; ++i)
            x[rows[static_cast<std::size_t>(i)]] -= below[i];
    }
    for (auto node = supernodes_.rbegin(); node != supernodes_.rend(); ++node) {
        const auto& [first, columns, rows, block] = *node;
        auto here = x.segment(first, columns);
        const auto count = static_cast<Eigen::Index>(rows.size());
        for (Eigen::Index i = 0; i < count; ++i)
            below[i] = x[rows[static_cast<std::size_t>(i)]];
        here.noalias() -= block.bottomRows(count).transpose() * below.head(count);
        block.topRows(columns).transpose().triangularView<Eigen::Upper>().solveInPlace(here);
    }

    for (Eigen::Index i = 0; i < b.size(); ++i)
        b[order_[static_cast<std::size_t>(i)]] = static_cast<double>(x[i]);
}
//! [block_solve]

}  // namespace enduring
