#include "exercises/10_self_contact/1_neighbours.hpp"

#include <algorithm>
#include <functional>
#include <queue>
#include <span>
#include <utility>

namespace enduring {
namespace {

double length_at_rest(const SoftShape& shape, const std::array<int, 2>& edge)
{
    return (shape.rest[edge[0]] - shape.rest[edge[1]]).norm();
}

bool are_near(const SoftShape& shape, std::span<const int> one, std::span<const int> other, double margin)
{
    Vec3 low[2], high[2];
    for (const int i : {0, 1}) {
        low[i] = Vec3::Constant(INFINITY);
        high[i] = -low[i];
        for (const int vertex : i == 0 ? one : other) {
            low[i] = low[i].cwiseMin(shape.now[vertex] - Vec3::Constant(margin));
            high[i] = high[i].cwiseMax(shape.now[vertex] + Vec3::Constant(margin));
        }
    }
    return (low[0].array() <= high[1].array()).all() && (low[1].array() <= high[0].array()).all();
}

}  // namespace

std::vector<double> paths_from(const SoftShape& shape, int vertex)
{
    std::vector<std::vector<std::pair<double, int>>> bonds(shape.rest.size());
    for (const auto& [u, v] : shape.bonds) {
        bonds[u].emplace_back(length_at_rest(shape, {u, v}), v);
        bonds[v].emplace_back(length_at_rest(shape, {u, v}), u);
    }
    std::vector<double> path(shape.rest.size(), INFINITY);
    std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> next;
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

Neighbours find_neighbours(const SoftShape& shape)
{
    const auto count = static_cast<std::size_t>(shape.surface_vertices);
    std::vector<double> longest(count, 0);
    for (const auto& edge : shape.edges)
        for (const int vertex : edge)
            longest[vertex] = std::max(longest[vertex], length_at_rest(shape, edge));
    const double longest_of_all = *std::max_element(longest.begin(), longest.end());
    Neighbours table(count, std::vector<bool>(count));
    for (int u = 0; u < shape.surface_vertices; ++u) {
        const std::vector<double> path = paths_from(shape, u);
        for (int v = 0; v < shape.surface_vertices; ++v)
            table[u][v] = length_at_rest(shape, {u, v}) <= std::max(longest[u], longest[v]) &&
                          path[v] <= 2 * longest_of_all;
    }
    return table;
}

OwnPairs find_own_pairs(const SoftShape& shape, const Neighbours& neighbours, double margin)
{
    const auto may_push = [&](std::span<const int> one, std::span<const int> other) {
        for (const int u : one)
            for (const int v : other)
                if (neighbours[u][v])
                    return false;
        return are_near(shape, one, other, margin);
    };
    OwnPairs pairs;
    for (int vertex = 0; vertex < shape.surface_vertices; ++vertex)
        for (int face = 0; face < static_cast<int>(shape.faces.size()); ++face)
            if (may_push({&vertex, 1}, shape.faces[face]))
                pairs.vertex_face.push_back({vertex, face});
    for (int edge = 0; edge < static_cast<int>(shape.edges.size()); ++edge)
        for (int other = edge + 1; other < static_cast<int>(shape.edges.size()); ++other)
            if (may_push(shape.edges[edge], shape.edges[other]))
                pairs.edge_edge.push_back({edge, other});
    return pairs;
}

}  // namespace enduring
