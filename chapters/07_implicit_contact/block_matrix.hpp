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

/// How many of a body's coordinates move together in pairs: six of a rigid body, three of a soft body's
/// vertex.
int coordinates_together(const BodyBlock& body);

/// The lower half of a sparse matrix over the coordinates of a problem that can be added to in place.
/// Coordinates that move together (coordinates_together()) have the same rows in their columns, so a block is
/// a matrix with a stride. It has a block for each two of them in one body, or in one element of a body with
/// all its nodes, and for each two that a pair couples. Memory and pattern are kept as long as the same
/// bodies touch.
class BlockMatrix {
public:
    /// Takes the pattern of the problem; entries are not yet set.
    /// @return  whether it is another one than before
    bool reset(const ContactProblem& problem);
    /// Sets all entries to zero.
    void clear() { matrix_.coeffs().setZero(); }

    /// The block whose first entry is this; it may go on through the rows of a body. Both have to lie in one
    /// body or in parts that a pair of the problem couples, with row not above column.
    BlockPlace at(int row, int column);

    const Eigen::SparseMatrix<double>& matrix() const { return matrix_; }

private:
    /// Coordinates that move together, and those from there on that they are coupled with.
    struct Column {
        int first, size;
        std::vector<int> neighbours;  ///< places among all columns, ascending, its own first
        bool operator==(const Column&) const = default;
    };
    std::vector<Column> find_columns(const ContactProblem& problem);
    void append_columns(const BodyBlock& body, std::vector<Column>& columns);
    void build();

    std::vector<int> column_of_;  ///< of each coordinate
    std::vector<Column> columns_;
    std::vector<std::vector<int>>
        rows_above_;  ///< of each column: the rows of the neighbours before each one, then of all
    Eigen::SparseMatrix<double> matrix_;
};

}  // namespace enduring
