#pragma once

#include "chapters/07_implicit_contact/contact_problem.hpp"

#include <Eigen/SparseCore>

#include <span>
#include <vector>

namespace enduring {

/// Where a block begins in a matrix that is stored column by column, and how far apart its columns are.
struct BlockPlace {
    double* entries;
    Eigen::Index stride;

    template <int Rows, int Columns>
    Eigen::Map<Eigen::Matrix<double, Rows, Columns>, 0, Eigen::OuterStride<>> block(
        int rows = Rows, int columns = Columns) const
    {
        return {entries, rows, columns, Eigen::OuterStride<>(stride)};
    }
};

/// A sparse matrix over the coordinates of a problem that can be added to in place. It has a full block for
/// each body, and for each two bodies that a pair couples. All columns of a body have the same rows, so a
/// block is a matrix with a stride. Memory and pattern are kept as long as the same bodies touch.
class BlockMatrix {
public:
    /// Sets all entries to zero.
    /// @return  whether the pattern is another one than before
    bool reset(const ContactProblem& problem);

    /// The block whose first entry is this. Both have to lie in bodies that a pair of the problem couples.
    BlockPlace at(int row, int column);

    const Eigen::SparseMatrix<double>& matrix() const { return matrix_; }

private:
    /// A body's coordinates, and those that they are coupled with.
    struct Column {
        int first, size;
        std::vector<int> neighbours;  ///< places of bodies among all, ascending, itself included
        auto operator<=>(const Column&) const = default;
    };
    std::vector<Column> find_columns(const ContactProblem& problem);
    void build();

    std::vector<int> column_of_;  ///< of each coordinate
    std::vector<Column> columns_;
    Eigen::SparseMatrix<double> matrix_;
};

}  // namespace enduring
