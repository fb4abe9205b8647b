#include "chapters/07_implicit_contact/block_matrix.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace enduring {

int coordinates_together(const BodyBlock& body)
{
    constexpr int of_rigid_body = 6, of_vertex = 3;
    return body.size() > of_rigid_body ? of_vertex : std::max(1, body.size());
}

/// Of a soft body with all its nodes: each is coupled with those that share an element.
void BlockMatrix::append_columns(const BodyBlock& body, std::vector<Column>& columns)
{
    const int before = static_cast<int>(columns.size());
    for (int node = 0; 3 * node < body.size(); ++node) {
        std::fill_n(column_of_.begin() + body.first + 3 * node, 3, before + node);
        columns.push_back({body.first + 3 * node, 3, {}});
        for (Eigen::SparseMatrix<double>::InnerIterator entry(body.whole->elastic, 3 * node + 2); entry;
             ++entry)
            if (entry.row() % 3 == 2)
                columns.back().neighbours.push_back(before + static_cast<int>(entry.row()) / 3);
    }
}

std::vector<BlockMatrix::Column> BlockMatrix::find_columns(const ContactProblem& problem)
{
    std::vector<Column> columns;
    column_of_.assign(static_cast<std::size_t>(problem.size), 0);
    for (const BodyBlock& body : problem.blocks) {
        const int together = coordinates_together(body), end = body.first + body.size();
        if (body.whole) {
            append_columns(body, columns);
            continue;
        }
        const int before = static_cast<int>(columns.size()),
                  behind = before + (body.size() + together - 1) / together;
        for (int first = body.first; first < end; first += together) {
            const int place = static_cast<int>(columns.size()), size = std::min(together, end - first);
            std::fill_n(column_of_.begin() + first, size, place);
            columns.push_back({first, size, std::vector<int>(static_cast<std::size_t>(behind - place))});
            std::iota(columns.back().neighbours.begin(), columns.back().neighbours.end(), place);
        }
    }
    const auto column_of = [&](const VertexMotion& part) {
        return column_of_[static_cast<std::size_t>(part.first)];
    };
    for (const PairRow& row : problem.rows)
        for (const VertexMotion& one : row.moving())
            for (const VertexMotion& other : row.moving()) {
                if (column_of(one) < column_of(other))
                    continue;
                std::vector<int>& known = columns[static_cast<std::size_t>(column_of(other))].neighbours;
                const auto place = std::lower_bound(known.begin(), known.end(), column_of(one));
                if (place == known.end() || *place != column_of(one))
                    known.insert(place, column_of(one));
            }
    return columns;
}

void BlockMatrix::build()
{
    const auto size = static_cast<Eigen::Index>(column_of_.size());
    matrix_ = Eigen::SparseMatrix<double>(size, size);
    std::vector<int> rows;
    std::vector<int> starts{0};
    rows_above_.clear();
    for (const Column& column : columns_) {
        std::vector<int> above{0};
        for (const int neighbour : column.neighbours)
            above.push_back(above.back() + columns_[static_cast<std::size_t>(neighbour)].size);
        for (int j = 0; j < column.size; ++j) {
            for (const int neighbour : column.neighbours)
                for (int i = 0; i < columns_[static_cast<std::size_t>(neighbour)].size; ++i)
                    rows.push_back(columns_[static_cast<std::size_t>(neighbour)].first + i);
            starts.push_back(static_cast<int>(rows.size()));
        }
        rows_above_.push_back(std::move(above));
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
    return is_new;
}

//! [at]
BlockPlace BlockMatrix::at(int row, int column)
{
    const auto own = static_cast<std::size_t>(column_of_[static_cast<std::size_t>(column)]);
    const int wanted = column_of_[static_cast<std::size_t>(row)];
    const std::vector<int>& known = columns_[own].neighbours;
    const auto place = std::lower_bound(known.begin(), known.end(), wanted) - known.begin();
    const Eigen::Index above = rows_above_[own][static_cast<std::size_t>(place)] + row -
                               columns_[static_cast<std::size_t>(wanted)].first;
    return {matrix_.valuePtr() + matrix_.outerIndexPtr()[column] + above, rows_above_[own].back()};
}
//! [at]

}  // namespace enduring
