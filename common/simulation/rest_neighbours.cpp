#include "common/simulation/rest_neighbours.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace enduring {
namespace {

/// A way along the edges is longer than the straight one. In a cell of a grid, whose corners are at most its
/// diagonal apart, it is by less than a half.
constexpr double max_detour = 2;

using Bonds = std::vector<std::vector<std::pair<int, double>>>;  ///< of each node: the others, and how far

Bonds bonds_of_nodes(std::span<const Vec3> rest, std::span<const std::pair<int, int>> bonds)
{
    Bonds all(rest.size());
    for (const auto& [u, v] : bonds) {
        const double length = (rest[u] - rest[v]).norm();
        all[u].emplace_back(v, length);
        all[v].emplace_back(u, length);
    }
    return all;
}

/// The nodes to which the way along the edges is at most so long, ascending (Dijkstra).
std::vector<int> within(const Bonds& bonds, int from, double most, std::vector<double>& way)
{
    using Reached = std::pair<double, int>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> next;
    std::vector<int> found{from};
    way[from] = 0;
    next.emplace(0, from);
    while (!next.empty()) {
        const auto [length, node] = next.top();
        next.pop();
        if (length > way[node])
            continue;
        for (const auto& [other, step] : bonds[node])
            if (length + step <= most && length + step < way[other]) {
                if (way[other] == std::numeric_limits<double>::infinity())
                    found.push_back(other);
                way[other] = length + step;
                next.emplace(way[other], other);
            }
    }
    for (const int node : found)
        way[node] = std::numeric_limits<double>::infinity();
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace

RestNeighbours::RestNeighbours(const SurfaceTopology& surface, std::span<const Vec3> rest,
                               std::span<const std::pair<int, int>> bonds)
    : surface_(surface), near_(static_cast<std::size_t>(surface.vertex_count()))
{
    std::vector<double> reach(near_.size(), 0);  // the longest edge at each vertex
    for (const auto& [u, v] : surface.edges())
        for (const int vertex : {u, v})
            reach[vertex] = std::max(reach[vertex], (rest[u] - rest[v]).norm());
    const Bonds of_nodes = bonds_of_nodes(rest, bonds);
    const double largest = *std::max_element(reach.begin(), reach.end());
    std::vector<double> way(rest.size(), std::numeric_limits<double>::infinity());
    //! [vertices]
    for (int u = 0; u < surface.vertex_count(); ++u)
        for (const int v : within(of_nodes, u, max_detour * largest, way))
            if (u < v && v < surface.vertex_count() &&
                (rest[u] - rest[v]).norm() <= std::max(reach[u], reach[v]))
                near_[u].push_back(v);
    //! [vertices]
}

bool RestNeighbours::vertices(int u, int v) const
{
    const auto& near = near_[std::min(u, v)];
    return u == v || std::binary_search(near.begin(), near.end(), std::max(u, v));
}

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
