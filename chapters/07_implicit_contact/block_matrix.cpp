#include "chapters/07_implicit_contact/block_matrix.hpp"

#include <algorithm>

namespace enduring {

std::vector<BlockMatrix::Column> BlockMatrix::find_columns(const ContactProblem& problem)
{
    std::vector<Column> columns;
    column_of_.assign(static_cast<std::size_t>(problem.size), 0);
    for (const BodyBlock& block : problem.blocks) {
        const int place = static_cast<int>(columns.size()), size = static_cast<int>(block.mass.rows());
        std::fill_n(column_of_.begin() + block.first, size, place);
        columns.push_back({block.first, size, {place}});
    }
    const auto body_of = [&](const VertexMotion& part) {
        return column_of_[static_cast<std::size_t>(part.first)];
    };
    for (const PairRow& row : problem.rows)
        for (const VertexMotion& one : row.moving())
            for (const VertexMotion& other : row.moving()) {
                std::vector<int>& known = columns[static_cast<std::size_t>(body_of(other))].neighbours;
                const auto place = std::lower_bound(known.begin(), known.end(), body_of(one));
                if (place == known.end() || *place != body_of(one))
                    known.insert(place, body_of(one));
            }
    return columns;
}

void BlockMatrix::build()
{
    const auto size = static_cast<Eigen::Index>(column_of_.size());
    matrix_ = Eigen::SparseMatrix<double>(size, size);
    std::vector<int> rows;
    std::vector<int> starts{0};
    for (const Column& column : columns_)
        for (int j = 0; j < column.size; ++j) {
            for (const int neighbour : column.neighbours)
                for (int i = 0; i < columns_[static_cast<std::size_t>(neighbour)].size; ++i)
                    rows.push_back(columns_[static_cast<std::size_t>(neighbour)].first + i);
            starts.push_back(static_cast<int>(rows.size()));
        }
    matrix_.resizeNonZeros(static_cast<Eigen::Index>(rows.size()));
    std::copy(rows.begin(), rows.end(), matrix_.innerIndexPtr());
    std::copy(starts.begin(), starts.end(), matrix_.outerIndexPtr());
}

bool BlockMatrix::reset(const ContactProblem& problem)
{
    std::vector<Column> columns = find_columns(problem);
    const bool is_new = columns != columns_;
    if (is_new) {
        columns_ = std::move(columns);
        build();
    }
    matrix_.coeffs().setZero();
    return is_new;
}

//! [at]
BlockPlace BlockMatrix::at(int row, int column)
{
    const Column& bodies = columns_[static_cast<std::size_t>(column_of_[static_cast<std::size_t>(column)])];
    const int wanted = column_of_[static_cast<std::size_t>(row)];
    Eigen::Index above = 0, height = 0;
    for (const int neighbour : bodies.neighbours) {
        const Column& other = columns_[static_cast<std::size_t>(neighbour)];
        if (neighbour < wanted)
            above += other.size;
        height += other.size;
    }
    above += row - columns_[static_cast<std::size_t>(wanted)].first;
    return {matrix_.valuePtr() + matrix_.outerIndexPtr()[column] + above, height};
}
//! [at]

}  // namespace enduring
