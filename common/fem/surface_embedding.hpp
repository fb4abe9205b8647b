#pragma once

#include "common/fem/elastic_mesh.hpp"

#include <span>
#include <vector>

namespace enduring {

/// A node's share in a surface vertex.
struct NodeWeight {
    int node;
    double weight;
};

/// Where the vertices of a body's surface are, as fixed combinations of its nodes: x = sum_i w_i c_i.
///
/// With linear elements a surface vertex is a node. With quadratic ones in Bernstein form a corner is a node
/// too, and the middle of an edge with corners a and b is c_a / 4 + c_ab / 2 + c_b / 4. An impulse goes back
/// the same way, so that it does the same work on the nodes as on the vertex: node i receives w_i times it.
class SurfaceEmbedding {
public:
    /// @param surface_nodes  the mesh node of each surface vertex (surface_of(mesh).nodes)
    /// @throws InputError    a node that is out of range or, for the quadratic mesh, in no element
    SurfaceEmbedding(const TetrahedralMesh& mesh, std::span<const int> surface_nodes);
    SurfaceEmbedding(const QuadraticTetrahedralMesh& mesh, std::span<const int> surface_nodes);

    int vertex_count() const { return static_cast<int>(offsets_.size()) - 1; }
    std::span<const NodeWeight> nodes_of(int vertex) const
    {
        return std::span(weights_).subspan(offsets_[vertex], offsets_[vertex + 1] - offsets_[vertex]);
    }
    /// The one with the largest share: the corner, or of the middle of an edge its control point.
    int own_node(int vertex) const;
    /// The same nodes without their shares.
    std::span<const int> node_numbers_of(int vertex) const
    {
        return std::span(numbers_).subspan(offsets_[vertex], offsets_[vertex + 1] - offsets_[vertex]);
    }

    /// Value of a nodal field (positions, velocities) at a vertex.
    Vec3 at(int vertex, const NodalVectors& field) const;
    /// ... and at all of them.
    void evaluate(const NodalVectors& field, std::span<Vec3> values) const;
    /// Adds to the velocities what an impulse [N s] at a vertex does to the nodes.
    /// @param inverse_masses  of the nodes [1/kg], zero where a node is fixed
    void apply_impulse(int vertex, const Vec3& impulse, const Eigen::VectorXd& inverse_masses,
                       NodalVectors& velocities) const;
    /// The vertex's change of velocity per impulse [1/kg], w^T M^-1 w: the same in every direction.
    double inverse_mass(int vertex, const Eigen::VectorXd& inverse_masses) const;

private:
    void end_vertex();

    std::vector<int> offsets_{0};
    std::vector<NodeWeight> weights_;
    std::vector<int> numbers_;  ///< the nodes of weights_
};

}  // namespace enduring
