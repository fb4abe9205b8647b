#include "exercises/05_categorisation/4_borrowed_normals.hpp"

namespace enduring {

/// What one hooked vertex borrows. The search goes out in rings: all neighbours, then all theirs, and stops
/// at the first ring with a regular vertex in it.
/// @param place  of a vertex in `buried`, -1 for one that is not buried
/// @param start  the hooked vertex, its place in `buried`
static std::optional<Vec3> borrowed_by(const SurfaceTopology& surface, std::span<const BuriedVertex> buried,
                                       const std::vector<int>& place, int start)
{
    std::vector<bool> seen(buried.size(), false);
    seen[start] = true;
    for (std::vector<int> ring = {start}, next; !ring.empty(); ring = std::move(next), next.clear()) {
        Vec3 sum = Vec3::Zero();
        bool found = false;
        for (const int from : ring)
            for (const int edge : surface.edges_around_vertex(buried[from].vertex)) {
                const auto [v0, v1] = surface.edges()[edge];
                const int other = place[v0 == buried[static_cast<std::size_t>(from)].vertex ? v1 : v0];
                if (other < 0 || seen[other])
                    continue;
                seen[other] = true;
                next.push_back(other);
                if (buried[other].category == ContactCategory::regular) {
                    sum += buried[other].normal;
                    found = true;
                }
            }
        if (found)
            return sum.norm() > 1e-9 ? std::optional<Vec3>(sum.normalized()) : std::nullopt;
    }
    return std::nullopt;
}

std::vector<std::optional<Vec3>> borrowed_normals(const SurfaceTopology& surface,
                                                  std::span<const BuriedVertex> buried)
{
    std::vector<int> place(static_cast<std::size_t>(surface.vertex_count()), -1);
    for (std::size_t i = 0; i < buried.size(); ++i)
        place[buried[i].vertex] = static_cast<int>(i);
    std::vector<std::optional<Vec3>> normals;
    for (std::size_t i = 0; i < buried.size(); ++i)
        normals.push_back(buried[i].category == ContactCategory::regular
                              ? std::optional<Vec3>(buried[i].normal)
                              : borrowed_by(surface, buried, place, static_cast<int>(i)));
    return normals;
}

}  // namespace enduring
