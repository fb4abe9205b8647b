#include "chapters/07_implicit_contact/block_cholesky.hpp"

#include <Eigen/Cholesky>
#include <Eigen/OrderingMethods>

#include <algorithm>
#include <iterator>

namespace enduring {
namespace {

using Block = BlockCholesky::Block;
constexpr int side = BlockCholesky::side;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// X L^T = A for X, column by column.
void divide_by_transpose(const Block& lower, Block& a)
{
    for (int column = 0; column < side; ++column) {
        for (int before = 0; before < column; ++before)
            a.col(column) -= lower(column, before) * a.col(before);
        a.col(column) /= lower(column, column);
    }
}

/// C - A B^T, one column of six sums at a time.
void subtract_product(const Block& a, const Block& b, Block& c)
{
    for (int column = 0; column < side; ++column) {
        Eigen::Matrix<double, side, 1> sum = c.col(column);
        for (int i = 0; i < side; ++i)
            sum -= b(column, i) * a.col(i);
        c.col(column) = sum;
    }
}

}  // namespace

BlockCholesky::BlockCholesky(const Eigen::SparseMatrix<double>& pattern)
    : columns_(static_cast<int>(pattern.cols()) / side)
{
    find_rows(order_blocks(pattern));
    find_sources(pattern);
}

/// The order that fills in least, by minimum degree, and the pattern of A in it.
BlockCholesky::Rows BlockCholesky::order_blocks(const Eigen::SparseMatrix<double>& pattern)
{
    std::vector<Eigen::Triplet<double>> entries;
    for (int column = 0; column < columns_; ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(pattern, side * column); entry; ++entry)
            if (entry.row() % side == 0)
                entries.emplace_back(static_cast<int>(entry.row()) / side, column, 1.0);
    Eigen::SparseMatrix<double> blocks(columns_, columns_);
    blocks.setFromTriplets(entries.begin(), entries.end());
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> old_place;
    Eigen::AMDOrdering<int>()(blocks.selfadjointView<Eigen::Lower>(), old_place);
    new_place_.resize(at(columns_));
    for (int i = 0; i < columns_; ++i)
        new_place_[at(old_place.indices()[i])] = i;
    Rows rows(at(columns_));
    for (const auto& entry : entries) {
        const auto [column, row] = std::minmax(new_place_[at(entry.row())], new_place_[at(entry.col())]);
        if (column != row)
            rows[at(column)].push_back(row);
    }
    return rows;
}

//! [find_rows]
/// Eliminating a column couples all its rows: those behind the first of them are rows of that column, too.
void BlockCholesky::find_rows(Rows rows)
{
    for (int column = 0; column < columns_; ++column) {
        std::vector<int>& own = rows[at(column)];
        std::sort(own.begin(), own.end());
        own.erase(std::unique(own.begin(), own.end()), own.end());
        if (!own.empty()) {
            std::vector<int>& next = rows[at(own.front())];
            next.insert(next.end(), own.begin() + 1, own.end());
        }
        first_.push_back(row_.size());
        row_.push_back(column);
        row_.insert(row_.end(), own.begin(), own.end());
    }
    first_.push_back(row_.size());
}
//! [find_rows]

std::span<const int> BlockCholesky::rows_of(int column) const
{
    return {row_.data() + first_[at(column)], row_.data() + first_[at(column) + 1]};
}

std::size_t BlockCholesky::place_of(int row, int column) const
{
    const std::span<const int> rows = rows_of(column);
    return first_[at(column)] +
           static_cast<std::size_t>(std::lower_bound(rows.begin(), rows.end(), row) - rows.begin());
}

void BlockCholesky::find_sources(const Eigen::SparseMatrix<double>& pattern)
{
    const int *starts = pattern.outerIndexPtr(), *rows = pattern.innerIndexPtr();
    for (int column = 0; column < columns_; ++column) {
        const int first = starts[side * column], behind = starts[side * column + 1];
        for (int entry = first; entry < behind; entry += side) {
            const int own = new_place_[at(column)], other = new_place_[at(rows[entry] / side)];
            sources_.push_back(
                {entry, behind - first, place_of(std::max(own, other), std::min(own, other)), other < own});
        }
    }
}

void BlockCholesky::find_updates()
{
    for (int column = 0; column < columns_; ++column) {
        const std::span<const int> rows = rows_of(column).subspan(1);
        for (std::size_t j = 0; j < rows.size(); ++j) {
            std::size_t place = first_[at(rows[j])];
            for (std::size_t i = j; i < rows.size(); ++i) {
                while (row_[place] != rows[i])
                    ++place;
                updated_.push_back(place);
            }
        }
    }
}

//! [factor]
bool BlockCholesky::factor(const Eigen::SparseMatrix<double>& matrix)
{
    if (updated_.empty())
        find_updates();
    blocks_.assign(row_.size(), Block::Zero());
    for (const auto& [entry, stride, place, transposed] : sources_) {
        const Eigen::Map<const Block, 0, Eigen::OuterStride<>> block(matrix.valuePtr() + entry,
                                                                     Eigen::OuterStride<>(stride));
        if (transposed)
            blocks_[place] = block.transpose();
        else
            blocks_[place] = block;
    }
    auto updated = updated_.begin();
    for (int column = 0; column < columns_; ++column) {
        if (!factor_column(column))
            return false;
        const std::size_t first = first_[at(column)] + 1, behind = first_[at(column) + 1];
        for (std::size_t j = first; j < behind; ++j)
            for (std::size_t i = j; i < behind; ++i)
                subtract_product(blocks_[i], blocks_[j], blocks_[*updated++]);
    }
    return true;
}

/// @return  false if its block on the diagonal is not positive definite
bool BlockCholesky::factor_column(int column)
{
    Block& diagonal = blocks_[first_[at(column)]];
    const Eigen::LLT<Block> lower(diagonal);
    if (lower.info() != Eigen::Success)
        return false;
    diagonal = lower.matrixLLT();
    for (std::size_t i = first_[at(column)] + 1; i < first_[at(column) + 1]; ++i)
        divide_by_transpose(diagonal, blocks_[i]);
    return true;
}
//! [factor]

/// @param x  unknowns in the factor's order: a vector, or one in each column
template <class Unknowns>
void BlockCholesky::solve_ordered(Unknowns& x) const
{
    const auto part = [&](int column) { return x.template middleRows<side>(side * column); };
    for (int column = 0; column < columns_; ++column) {
        auto own = part(column);
        std::size_t place = first_[at(column)];
        blocks_[place].triangularView<Eigen::Lower>().solveInPlace(own);
        for (const int row : rows_of(column).subspan(1))
            part(row).noalias() -= blocks_[++place] * own;
    }
    for (int column = columns_; column-- > 0;) {
        auto own = part(column);
        std::size_t place = first_[at(column)];
        for (const int row : rows_of(column).subspan(1))
            own.noalias() -= blocks_[++place].transpose() * part(row);
        blocks_[first_[at(column)]].triangularView<Eigen::Lower>().transpose().solveInPlace(own);
    }
}

namespace {

/// Each six rows where they stand in the other order.
template <class Unknowns>
Unknowns ordered(const Unknowns& x, const std::vector<int>& place, bool back)
{
    Unknowns y(x.rows(), x.cols());
    for (int i = 0; i < static_cast<int>(place.size()); ++i) {
        const int from = back ? place[at(i)] : i, to = back ? i : place[at(i)];
        y.template middleRows<side>(side * to) = x.template middleRows<side>(side * from);
    }
    return y;
}

}  // namespace

void BlockCholesky::solve(Eigen::VectorXd& b) const
{
    Eigen::VectorXd x = ordered(b, new_place_, false);
    solve_ordered(x);
    b = ordered(x, new_place_, true);
}

void BlockCholesky::solve(Eigen::MatrixXd& b) const
{
    Eigen::MatrixXd x = ordered(b, new_place_, false);
    solve_ordered(x);
    b = ordered(x, new_place_, true);
}

double BlockCholesky::operations() const
{
    constexpr double side_cubed = side * side * side;
    double products = 0;
    for (int column = 0; column < columns_; ++column) {
        const auto rows = static_cast<double>(rows_of(column).size()) - 1;
        products += rows * rows + rows + 1.0 / 3;
    }
    return products * side_cubed;
}

}  // namespace enduring
