#pragma once

#include "common/fem/stiffness_assembly.hpp"
#include "common/fem/whole_turn.hpp"

#include <array>
#include <functional>
#include <vector>

namespace enduring {

/// The matrix A of a body's step over all its nodes, for a solver that adds to it. Its coordinates are the
/// velocities *at* the nodes, three each: of the middle of an edge in place of its control point. So what
/// pushes a vertex of the surface pushes three coordinates only.
struct WholeMatrix {
    Eigen::SparseMatrix<double>
        elastic;  ///< a M + b K, the lower triangle [kg]; of a fixed node the identity
    /// G and U, three columns each: A is `elastic` less b (G U^T + U G^T), which is what K holds against a
    /// turn of the whole body. Without columns where K is taken as it is.
    Eigen::MatrixXd turn;
    double stiffness_scale = 0;  ///< b [s^2]
    Eigen::VectorXd masses;      ///< the diagonal of M [kg]: what a norm takes in place of A
    /// nearly A^-1 times a momentum, see ElasticBody::near_response(); the body outlives it
    std::function<Eigen::VectorXd(const Eigen::VectorXd&)> respond;

    int size() const { return static_cast<int>(elastic.rows()); }
    Eigen::VectorXd times(const Eigen::VectorXd& x) const;
};

/// Builds it, again and again for the same fixed nodes. A linear element's coefficients are values at its
/// nodes; of a quadratic one c_ab = 2 x_ab - (c_a + c_b) / 2 with the value x_ab in the middle of an edge.
/// Both are bases of the same fields, so that their matrices have the same pattern.
class WholeAssembly {
public:
    /// @param mass_matrix  M of the mesh, one row a node; as the mesh it outlives this
    /// @param fixed        one flag a node
    /// @param keeps        whether each element's part of K is the same in its axes for ever
    WholeAssembly(const ElasticMesh& mesh, const Eigen::SparseMatrix<double>& mass_matrix,
                  std::vector<char> fixed, bool keeps);

    /// Without `respond`.
    WholeMatrix assemble(const Elasticity& elasticity, const WholeTurn* turn, double mass_scale,
                         double stiffness_scale);
    /// From coefficients to values at the nodes.
    NodalVectors values(NodalVectors coefficients) const;
    /// From impulses at the nodes to those on coefficients that do the same work.
    NodalVectors on_coefficients(NodalVectors impulses) const;

private:
    struct Edge {
        int middle;
        std::array<int, 2> ends;
    };
    Eigen::MatrixXd at_nodes(const Elasticity& elasticity, int element) const;
    Eigen::VectorXd at_nodes(NodalVectors forces) const;

    std::vector<char> fixed_;
    bool keeps_;
    std::vector<Edge> edges_;  ///< whose middles are free
    StiffnessAssembly assembly_;
    Eigen::SparseMatrix<double> mass_matrix_;  ///< of values at the nodes
    std::vector<Eigen::MatrixXd> kept_;        ///< of each element
};

}  // namespace enduring
