#include "common/fem/stiffness_assembly.hpp"

#include <algorithm>
#include <array>

namespace enduring {
namespace {

/// Calls visit(row node, column node, local row, local column) for the blocks of the lower triangle.
template <class Visit>
void for_each_lower_block(const ElasticElement& element, int nodes, const Visit& visit)
{
    for (int a = 0; a < nodes; ++a)
        for (int b = 0; b < nodes; ++b)
            if (element.nodes[a] >= element.nodes[b])
                visit(element.nodes[a], element.nodes[b], a, b);
}

}  // namespace

StiffnessAssembly::StiffnessAssembly(const ElasticMesh& mesh)
{
    const int count = mesh.node_count(), per_element = nodes_of(mesh.basis());
    std::vector<std::array<int, 2>> pairs;  // column node, row node
    for (const ElasticElement& element : mesh.elements())
        for_each_lower_block(element, per_element, [&](int row, int column, int, int) {
            if (row > column)
                pairs.push_back({column, row});
        });
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());

    offsets_.assign(count + 1, 0);
    for (const auto& [column, row] : pairs) {
        ++offsets_[column + 1];
        lower_neighbours_.push_back(row);
    }
    for (int n = 0; n < count; ++n)
        offsets_[n + 1] += offsets_[n];
    for (const ElasticElement& element : mesh.elements())
        for_each_lower_block(element, per_element,
                             [&](int row, int column, int, int) { ranks_.push_back(rank_of(row, column)); });

    matrix_.resize(3 * count, 3 * count);
    matrix_.reserve(static_cast<Eigen::Index>(9 * pairs.size()) + 6 * count);
    for (int n = 0; n < count; ++n)
        for (int column = 0; column < 3; ++column) {
            matrix_.startVec(3 * n + column);
            for (int row = column; row < 3; ++row)
                matrix_.insertBack(3 * n + row, 3 * n + column) = 0;
            for (int i = offsets_[n]; i < offsets_[n + 1]; ++i)
                for (int row = 0; row < 3; ++row)
                    matrix_.insertBack(3 * lower_neighbours_[i] + row, 3 * n + column) = 0;
        }
    matrix_.finalize();
}

int StiffnessAssembly::rank_of(int row_node, int column_node) const
{
    const auto first = lower_neighbours_.begin() + offsets_[column_node],
               last = lower_neighbours_.begin() + offsets_[column_node + 1];
    return static_cast<int>(std::lower_bound(first, last, row_node) - first);
}

/// Where rows 3 row_node.. of that block's column start; in a diagonal
/// block the first of them is the diagonal itself.
double* StiffnessAssembly::block_column(int row_node, int column_node, int column, int rank)
{
    double* start = matrix_.valuePtr() + matrix_.outerIndexPtr()[3 * column_node + column];
    return row_node == column_node ? start : start + (3 - column) + 3 * rank;
}

/// M links the nodes that K links, in the same order: what stands below the
/// diagonal of its column n are the lower neighbours of n.
void StiffnessAssembly::add_masses(const Eigen::SparseMatrix<double>& mass_matrix,
                                   const std::vector<char>& fixed, double scale)
{
    for (int n = 0; n < static_cast<int>(mass_matrix.cols()); ++n) {
        int rank = 0;
        for (Eigen::SparseMatrix<double>::InnerIterator entry(mass_matrix, n); entry; ++entry) {
            const int row = static_cast<int>(entry.row());
            if (row < n)
                continue;
            for (int j = 0; j < 3; ++j) {
                if (row == n)
                    *block_column(n, n, j, 0) += fixed[n] ? 1 : scale * entry.value();
                else if (!fixed[row] && !fixed[n])
                    block_column(row, n, j, rank)[j] += scale * entry.value();
            }
            rank += row > n;
        }
    }
}

const Eigen::SparseMatrix<double>& StiffnessAssembly::assemble(
    const Elasticity& elasticity, const Eigen::SparseMatrix<double>& mass_matrix,
    const std::vector<char>& fixed, double mass_scale, double stiffness_scale,
    const std::function<Eigen::MatrixXd(int)>& stiffness_of)
{
    const ElasticMesh& mesh = elasticity.mesh();
    matrix_.coeffs().setZero();
    std::size_t pair = 0;
    for (std::size_t e = 0; e < mesh.elements().size(); ++e) {
        const Eigen::MatrixXd stiffness = stiffness_of ? stiffness_of(static_cast<int>(e))
                                                       : elasticity.stiffness_of(static_cast<int>(e));
        const Mat3 rotation = elasticity.axes_of(static_cast<int>(e));
        for_each_lower_block(
            mesh.elements()[e], nodes_of(mesh.basis()), [&](int row, int column, int a, int b) {
                const int rank = ranks_[pair++];
                if (fixed[row] || fixed[column])
                    return;
                const Mat3 block = stiffness_scale * rotation * stiffness.block<3, 3>(3 * a, 3 * b) *
                                   rotation.transpose();
                for (int j = 0; j < 3; ++j) {
                    double* entry = block_column(row, column, j, rank);
                    for (int i = row == column ? j : 0; i < 3; ++i)
                        *entry++ += block(i, j);
                }
            });
    }
    add_masses(mass_matrix, fixed, mass_scale);
    return matrix_;
}

}  // namespace enduring
