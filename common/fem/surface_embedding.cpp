#include "common/fem/surface_embedding.hpp"

#include "common/input/input_error.hpp"

#include <algorithm>
#include <string>

namespace enduring {
namespace {

void demand_node(int node, std::size_t count)
{
    if (node < 0 || node >= static_cast<int>(count))
        throw InputError("surface node " + std::to_string(node) +
                         " is not a node of the mesh; allowed are 0 to " +
                         std::to_string(static_cast<int>(count) - 1));
}

/// The corners of the edge a node is the middle of; {n, n} for a corner n; {-1, -1} for a node in no element.
std::vector<std::array<int, 2>> ends_of_nodes(const QuadraticTetrahedralMesh& mesh)
{
    std::vector<std::array<int, 2>> ends(mesh.nodes.size(), {-1, -1});
    for (const auto& element : mesh.elements) {
        for (std::size_t corner = 0; corner < 4; ++corner)
            ends[element[corner]] = {element[corner], element[corner]};
        for (std::size_t e = 0; e < tetrahedron_edges.size(); ++e)
            ends[element[4 + e]] = {element[tetrahedron_edges[e][0]], element[tetrahedron_edges[e][1]]};
    }
    return ends;
}

}  // namespace

SurfaceEmbedding::SurfaceEmbedding(const TetrahedralMesh& mesh, std::span<const int> surface_nodes)
{
    for (int node : surface_nodes) {
        demand_node(node, mesh.nodes.size());
        weights_.push_back({node, 1});
        end_vertex();
    }
}

SurfaceEmbedding::SurfaceEmbedding(const QuadraticTetrahedralMesh& mesh, std::span<const int> surface_nodes)
{
    const auto ends = ends_of_nodes(mesh);
    for (int node : surface_nodes) {
        demand_node(node, mesh.nodes.size());
        const auto [a, b] = ends[node];
        if (a < 0)
            throw InputError("surface node " + std::to_string(node) + " belongs to no element");
        if (a == b)
            weights_.push_back({node, 1});
        else
            weights_.insert(weights_.end(), {{a, 0.25}, {node, 0.5}, {b, 0.25}});
        end_vertex();
    }
}

void SurfaceEmbedding::end_vertex()
{
    offsets_.push_back(static_cast<int>(weights_.size()));
    for (std::size_t i = numbers_.size(); i < weights_.size(); ++i)
        numbers_.push_back(weights_[i].node);
}

int SurfaceEmbedding::own_node(int vertex) const
{
    const auto nodes = nodes_of(vertex);
    return std::max_element(nodes.begin(), nodes.end(),
                            [](const NodeWeight& a, const NodeWeight& b) { return a.weight < b.weight; })
        ->node;
}

Vec3 SurfaceEmbedding::at(int vertex, const NodalVectors& field) const
{
    Vec3 value = Vec3::Zero();
    for (const auto& [node, weight] : nodes_of(vertex))
        value += weight * field.col(node);
    return value;
}

void SurfaceEmbedding::evaluate(const NodalVectors& field, std::span<Vec3> values) const
{
    for (int v = 0; v < vertex_count(); ++v)
        values[v] = at(v, field);
}

//! [apply_impulse]
void SurfaceEmbedding::apply_impulse(int vertex, const Vec3& impulse, const Eigen::VectorXd& inverse_masses,
                                     NodalVectors& velocities) const
{
    for (const auto& [node, weight] : nodes_of(vertex))
        velocities.col(node) += weight * inverse_masses[node] * impulse;
}
//! [apply_impulse]

double SurfaceEmbedding::inverse_mass(int vertex, const Eigen::VectorXd& inverse_masses) const
{
    double sum = 0;
    for (const auto& [node, weight] : nodes_of(vertex))
        sum += weight * weight * inverse_masses[node];
    return sum;
}

}  // namespace enduring
