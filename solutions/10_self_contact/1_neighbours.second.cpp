#include "exercises/10_self_contact/1_neighbours.hpp"

#include <algorithm>

namespace enduring {

// Bellman and Ford: pass over all bonds until no path gets shorter.
std::vector<double> paths_from(const SoftShape& shape, int vertex)
{
    std::vector<double> path(shape.rest.size(), INFINITY);
    path[vertex] = 0;
    for (bool shorter = true; shorter;) {
        shorter = false;
        for (const auto& [u, v] : shape.bonds) {
            const double length = (shape.rest[u] - shape.rest[v]).norm();
            for (const auto& [from, to] : {std::pair(u, v), std::pair(v, u)})
                if (path[from] + length < path[to]) {
                    path[to] = path[from] + length;
                    shorter = true;
                }
        }
    }
    return path;
}

// Edge by edge: whoever is within an edge of one of its ends is a neighbour of this end, if the body lies between.
Neighbours find_neighbours(const SoftShape& shape)
{
    double longest = 0;
    for (const auto& [u, v] : shape.edges)
        longest = std::max(longest, (shape.rest[u] - shape.rest[v]).norm());
    const auto count = static_cast<std::size_t>(shape.surface_vertices);
    Neighbours table(count, std::vector<bool>(count));
    for (std::size_t u = 0; u < count; ++u)
        table[u][u] = true;
    for (const auto& edge : shape.edges)
        for (const int end : edge) {
            const double reach = (shape.rest[edge[0]] - shape.rest[edge[1]]).norm();
            const std::vector<double> path = paths_from(shape, end);
            for (std::size_t v = 0; v < count; ++v)
                if ((shape.rest[end] - shape.rest[v]).norm() <= reach && path[v] <= 2 * longest)
                    table[end][v] = table[v][end] = true;
        }
    return table;
}

// By distances of intervals: two boxes are near if they are so in each coordinate.
OwnPairs find_own_pairs(const SoftShape& shape, const Neighbours& neighbours, double margin)
{
    const auto gap = [&](const auto& one, const auto& other, int axis) {
        const auto [low, high] = std::minmax_element(
            one.begin(), one.end(), [&](int u, int v) { return shape.now[u][axis] < shape.now[v][axis]; });
        const auto [low_other, high_other] = std::minmax_element(
            other.begin(), other.end(),
            [&](int u, int v) { return shape.now[u][axis] < shape.now[v][axis]; });
        return std::max(shape.now[*low_other][axis] - shape.now[*high][axis],
                        shape.now[*low][axis] - shape.now[*high_other][axis]);
    };
    const auto visit = [&](const auto& one, const auto& other) {
        const bool next_to_it = std::any_of(one.begin(), one.end(), [&](int u) {
            return std::any_of(other.begin(), other.end(), [&](int v) { return neighbours[u][v]; });
        });
        return !next_to_it && gap(one, other, 0) <= 2 * margin && gap(one, other, 1) <= 2 * margin &&
               gap(one, other, 2) <= 2 * margin;
    };
    OwnPairs pairs;
    for (int face = 0; face < static_cast<int>(shape.faces.size()); ++face)
        for (int vertex = 0; vertex < shape.surface_vertices; ++vertex)
            if (visit(std::array{vertex}, shape.faces[face]))
                pairs.vertex_face.push_back({vertex, face});
    std::sort(pairs.vertex_face.begin(), pairs.vertex_face.end());
    for (int edge = 0; edge < static_cast<int>(shape.edges.size()); ++edge)
        for (int other = edge + 1; other < static_cast<int>(shape.edges.size()); ++other)
            if (visit(shape.edges[edge], shape.edges[other]))
                pairs.edge_edge.push_back({edge, other});
    return pairs;
}

}  // namespace enduring
