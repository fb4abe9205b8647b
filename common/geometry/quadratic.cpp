#include "common/geometry/quadratic.hpp"

#include "common/geometry/sort_once.hpp"

#include <algorithm>

namespace enduring {
namespace {

Edge edge_between(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

std::vector<Edge> distinct_edges(const TetrahedralMesh& mesh)
{
    std::vector<Edge> edges;
    edges.reserve(6 * mesh.elements.size());
    for (const auto& element : mesh.elements)
        for (const auto& [i, j] : tetrahedron_edges)
            edges.push_back(edge_between(element[i], element[j]));
    sort_once(edges);
    return edges;
}

}  // namespace

QuadraticTetrahedralMesh with_edge_midpoints(const TetrahedralMesh& mesh)
{
    const std::vector<Edge> edges = distinct_edges(mesh);
    QuadraticTetrahedralMesh result;
    result.corner_count = static_cast<int>(mesh.nodes.size());
    result.nodes = mesh.nodes;
    for (const auto& [a, b] : edges)
        result.nodes.push_back(0.5 * (mesh.nodes[a] + mesh.nodes[b]));

    for (const auto& corners : mesh.elements) {
        std::array<int, 10> element{};
        std::copy(corners.begin(), corners.end(), element.begin());
        for (std::size_t e = 0; e < tetrahedron_edges.size(); ++e) {
            const auto [i, j] = tetrahedron_edges[e];
            const Edge edge = edge_between(corners[i], corners[j]);
            const auto found = std::lower_bound(edges.begin(), edges.end(), edge);
            element[4 + e] = result.corner_count + static_cast<int>(found - edges.begin());
        }
        result.elements.push_back(element);
    }
    return result;
}

TetrahedralMesh corners_of(const QuadraticTetrahedralMesh& mesh)
{
    TetrahedralMesh result;
    result.nodes.assign(mesh.nodes.begin(), mesh.nodes.begin() + mesh.corner_count);
    for (const auto& element : mesh.elements)
        result.elements.push_back({element[0], element[1], element[2], element[3]});
    return result;
}

}  // namespace enduring
