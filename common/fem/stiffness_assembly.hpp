#pragma once

#include "common/fem/elasticity.hpp"

#include <Eigen/SparseCore>

#include <functional>
#include <vector>

namespace enduring {

/// Builds a M + b K_R as a sparse matrix, its lower triangle only. Where the entries lie is settled once, by
/// the mesh; assembling again writes numbers into known places. Unknown 3 n + i is component i of node n.
class StiffnessAssembly {
public:
    explicit StiffnessAssembly(const ElasticMesh& mesh);

    /// @param mass_matrix  M of the same mesh, one row a node
    /// @param fixed        one flag a node: rows and columns of a fixed node become those of the identity
    /// @param stiffness_of  an element's part of K in place of the elasticity's, in the same axes
    const Eigen::SparseMatrix<double>& assemble(const Elasticity& elasticity,
                                                const Eigen::SparseMatrix<double>& mass_matrix,
                                                const std::vector<char>& fixed, double mass_scale,
                                                double stiffness_scale,
                                                const std::function<Eigen::MatrixXd(int)>& stiffness_of = {});

    /// The zero matrix with every entry in place.
    const Eigen::SparseMatrix<double>& pattern() const { return matrix_; }

private:
    void add_masses(const Eigen::SparseMatrix<double>& mass_matrix, const std::vector<char>& fixed,
                    double scale);
    double* block_column(int row_node, int column_node, int column, int rank);
    int rank_of(int row_node, int column_node) const;

    /// Below the diagonal block of a node's column stand the blocks of these nodes, ascending.
    std::vector<int> offsets_, lower_neighbours_;
    std::vector<int> ranks_;  ///< of each element's pairs of nodes, element by element
    Eigen::SparseMatrix<double> matrix_;
};

}  // namespace enduring
