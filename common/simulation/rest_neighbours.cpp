#include "common/simulation/rest_neighbours.hpp"

#include <algorithm>

namespace enduring {

RestNeighbours::RestNeighbours(const SurfaceTopology& surface, std::span<const Vec3> rest)
    : surface_(surface), rest_(rest.begin(), rest.end()), reach_(rest.size(), 0)
{
    for (const auto& [u, v] : surface.edges()) {
        const double squared_length = (rest_[u] - rest_[v]).squaredNorm();
        reach_[u] = std::max(reach_[u], squared_length);
        reach_[v] = std::max(reach_[v], squared_length);
    }
}

//! [vertices]
bool RestNeighbours::vertices(int u, int v) const
{
    return (rest_[u] - rest_[v]).squaredNorm() <= std::max(reach_[u], reach_[v]);
}
//! [vertices]

bool RestNeighbours::vertex_and_face(int vertex, int face) const
{
    const Face& corners = surface_.faces()[face];
    return std::any_of(corners.begin(), corners.end(), [&](int corner) { return vertices(vertex, corner); });
}

bool RestNeighbours::edges(int edge, int other) const
{
    const auto [a0, a1] = surface_.edges()[edge];
    const auto [b0, b1] = surface_.edges()[other];
    return vertices(a0, b0) || vertices(a0, b1) || vertices(a1, b0) || vertices(a1, b1);
}

bool RestNeighbours::edge_and_face(int edge, int face) const
{
    const auto [e0, e1] = surface_.edges()[edge];
    return vertex_and_face(e0, face) || vertex_and_face(e1, face);
}

}  // namespace enduring
