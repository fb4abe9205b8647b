#pragma once

#include "common/geometry/vector.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

namespace enduring {

/// A soft body. Its first vertices are those of its surface, and the others lie inside.
struct SoftShape {
    std::vector<Vec3> rest;                 ///< where each vertex lies while nothing is strained [m]
    std::vector<Vec3> now;                  ///< and where it lies now [m]
    int surface_vertices = 0;               ///< how many of them the surface has
    std::vector<std::array<int, 3>> faces;  ///< of the surface
    std::vector<std::array<int, 2>> edges;  ///< of the surface
    std::vector<std::array<int, 2>> bonds;  ///< edges of all elements, those of the surface among them
};

/// table[u][v] of the surface's vertices: whether u and v are neighbours.
using Neighbours = std::vector<std::vector<bool>>;

/// Two vertices of the surface are neighbours if, at rest,
/// - the straight line between them is no longer than the longest edge of the surface that ends at one of the
/// two, and
/// - the path along the bonds is no longer than twice the longest edge of the whole surface.
/// Each vertex is a neighbour of itself.
Neighbours find_neighbours(const SoftShape& shape);

/// Pairs of features of one surface, each an index into its list.
struct FoundPairs {
    std::vector<std::array<int, 2>> vertex_face;
    std::vector<std::array<int, 2>> edge_edge;  ///< the smaller edge first
};

/// The pairs of features that lie near each other now and may push: each once, both lists ascending. They may
/// not push if some vertex of the one is a neighbour of some vertex of the other.
/// @param margin  see are_near() [m]
FoundPairs find_own_pairs(const SoftShape& shape, const Neighbours& neighbours, double margin);

/// Given: how far it is at rest from one vertex to each of all vertices along the bonds [m]; INFINITY where
/// no bonds lead (Dijkstra).
inline std::vector<double> paths_from(const SoftShape& shape, int vertex)
{
    using Reached = std::pair<double, int>;
    std::vector<std::vector<Reached>> bonds(shape.rest.size());
    for (const auto& [u, v] : shape.bonds) {
        const double length = (shape.rest[u] - shape.rest[v]).norm();
        bonds[u].emplace_back(length, v);
        bonds[v].emplace_back(length, u);
    }
    std::vector<double> path(shape.rest.size(), INFINITY);
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> next;
    next.emplace(path[vertex] = 0, vertex);
    while (!next.empty()) {
        const auto [so_far, u] = next.top();
        next.pop();
        for (const auto& [length, v] : bonds[u])
            if (so_far + length < path[v])
                next.emplace(path[v] = so_far + length, v);
    }
    return path;
}

/// Given: whether the boxes around some vertices and around others, as they lie now, each larger by the
/// margin on all sides, have a point in common.
inline bool are_near(const SoftShape& shape, std::span<const int> one, std::span<const int> other,
                     double margin)
{
    for (int axis = 0; axis < 3; ++axis) {
        double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
        for (const int i : {0, 1})
            for (const int vertex : i == 0 ? one : other) {
                low[i] = std::min(low[i], shape.now[vertex][axis] - margin);
                high[i] = std::max(high[i], shape.now[vertex][axis] + margin);
            }
        if (low[0] > high[1] || low[1] > high[0])
            return false;
    }
    return true;
}

}  // namespace enduring
