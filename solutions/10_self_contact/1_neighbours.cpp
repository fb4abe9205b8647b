#include "exercises/10_self_contact/1_neighbours.hpp"

namespace enduring {

Neighbours find_neighbours(const SoftShape& shape)
{
    const auto length = [&](int u, int v) { return (shape.rest[u] - shape.rest[v]).norm(); };
    std::vector<double> reach(static_cast<std::size_t>(shape.surface_vertices), 0);
    for (const auto& [u, v] : shape.edges)
        for (const int end : {u, v})
            reach[end] = std::max(reach[end], length(u, v));
    const double longest = *std::max_element(reach.begin(), reach.end());
    Neighbours table(reach.size(), std::vector<bool>(reach.size()));
    for (int u = 0; u < shape.surface_vertices; ++u) {
        const std::vector<double> path = paths_from(shape, u);
        for (int v = 0; v < shape.surface_vertices; ++v)
            table[u][v] = length(u, v) <= std::max(reach[u], reach[v]) && path[v] <= 2 * longest;
    }
    return table;
}

FoundPairs find_own_pairs(const SoftShape& shape, const Neighbours& neighbours, double margin)
{
    const auto may_push = [&](std::span<const int> one, std::span<const int> other) {
        for (const int u : one)
            for (const int v : other)
                if (neighbours[u][v])
                    return false;
        return are_near(shape, one, other, margin);
    };
    FoundPairs pairs;
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
