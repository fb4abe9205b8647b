#include "exercises/10_self_contact/1_neighbours.hpp"

#include <set>

namespace enduring {

// Edge by edge: what is within the length of an edge of one of its ends is a neighbour of this end, if the
// body lies between.
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
            const double length = (shape.rest[edge[0]] - shape.rest[edge[1]]).norm();
            const std::vector<double> path = paths_from(shape, end);
            for (std::size_t v = 0; v < count; ++v)
                if ((shape.rest[end] - shape.rest[v]).norm() <= length && path[v] <= 2 * longest)
                    table[end][v] = table[v][end] = true;
        }
    return table;
}

// What is around a feature first: the vertices that are next to it. A feature with one of them may not push.
FoundPairs find_own_pairs(const SoftShape& shape, const Neighbours& neighbours, double margin)
{
    const auto around = [&](std::span<const int> feature) {
        std::set<int> all;
        for (const int vertex : feature)
            for (int other = 0; other < shape.surface_vertices; ++other)
                if (neighbours[vertex][other])
                    all.insert(other);
        return all;
    };
    const auto has_one_of = [](std::span<const int> feature, const std::set<int>& vertices) {
        return std::any_of(feature.begin(), feature.end(), [&](int v) { return vertices.contains(v); });
    };
    FoundPairs pairs;
    for (int face = 0; face < static_cast<int>(shape.faces.size()); ++face) {
        const std::set<int> next_to_it = around(shape.faces[face]);
        for (int vertex = 0; vertex < shape.surface_vertices; ++vertex)
            if (!next_to_it.contains(vertex) && are_near(shape, {&vertex, 1}, shape.faces[face], margin))
                pairs.vertex_face.push_back({vertex, face});
    }
    std::sort(pairs.vertex_face.begin(), pairs.vertex_face.end());
    for (int edge = 0; edge < static_cast<int>(shape.edges.size()); ++edge) {
        const std::set<int> next_to_it = around(shape.edges[edge]);
        for (int other = edge + 1; other < static_cast<int>(shape.edges.size()); ++other)
            if (!has_one_of(shape.edges[other], next_to_it) &&
                are_near(shape, shape.edges[edge], shape.edges[other], margin))
                pairs.edge_edge.push_back({edge, other});
    }
    return pairs;
}

}  // namespace enduring
