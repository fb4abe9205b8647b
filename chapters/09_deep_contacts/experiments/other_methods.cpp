#include "chapters/09_deep_contacts/experiments/other_methods.hpp"

#include <algorithm>

namespace enduring::chapter09 {
namespace {

/// Of the border: where edges next to a vertex inside pass the other surface, and its normals there.
struct BorderPoint {
    int vertex;  ///< of the inner surface, inside
    Vec3 point, normal;
};

Vec3 face_normal(const StillSurface& surface, int face)
{
    const auto [a, b, c] = surface.topology.faces()[face];
    const auto x = surface.positions;
    return (x[b] - x[a]).cross(x[c] - x[a]).normalized();
}

std::vector<BorderPoint> border_of(const StillSurface& inner, const StillSurface& outer)
{
    std::vector<BorderPoint> border;
    for (const Piercing& piercing : find_piercings(inner, outer))
        if (piercing.edge_of_a) {
            const auto [from, to] = inner.topology.edges()[piercing.edge];
            border.push_back({piercing.entry > 0 ? to : from, point_of(piercing, inner, outer),
                              face_normal(outer, piercing.face)});
        }
    return border;
}

double weight_of(const Vec3& from, const Vec3& to) { return 1 / std::max(1e-24, (to - from).squaredNorm()); }

}  // namespace

std::vector<Vec3> overlap_direction(const StillSurface&, const std::vector<int>& vertices,
                                    const StillSurface&, const Vec3& separation_direction)
{
    return std::vector<Vec3>(vertices.size(), separation_direction);
}

//! [from_the_border]
std::vector<Vec3> directions_from_the_border(const StillSurface& inner, const std::vector<int>& vertices,
                                             const StillSurface& outer, const Vec3&)
{
    std::vector<Vec3> way(inner.positions.size(), Vec3::Zero());
    for (const BorderPoint& border : border_of(inner, outer))
        way[border.vertex] += weight_of(border.point, inner.positions[border.vertex]) * border.normal;
    for (Vec3& w : way)
        w.stableNormalize();
    for (bool more = true; more;) {  // one row of vertices further in
        more = false;
        const std::vector<Vec3> known = way;
        for (const int vertex : vertices) {
            if (!known[vertex].isZero(0))
                continue;
            for (const int edge : inner.topology.edges_around_vertex(vertex)) {
                const auto [v0, v1] = inner.topology.edges()[edge];
                const int neighbour = v0 == vertex ? v1 : v0;
                way[vertex] += weight_of(inner.positions[neighbour], inner.positions[vertex]) *
                               known[neighbour];
            }
            way[vertex].stableNormalize();
            more = more || !way[vertex].isZero(0);
        }
    }
    std::vector<Vec3> ways;
    for (const int vertex : vertices)
        ways.push_back(way[vertex]);
    return ways;
}
//! [from_the_border]

//! [to_the_boundary]
std::vector<Vec3> directions_to_the_boundary(const StillSurface& inner, const std::vector<int>& vertices,
                                             const StillSurface& outer, const Vec3&)
{
    std::vector<Vec3> ways;
    for (const int vertex : vertices)
        ways.push_back(nearest_normal(outer, inner.positions[vertex]));
    return ways;
}
//! [to_the_boundary]

}  // namespace enduring::chapter09
