#include "chapters/09_deep_contacts/surface_regions.hpp"

namespace enduring {

//! [flood_regions]
SurfaceRegions flood_regions(const std::vector<Piercing>& piercings, const StillSurface& a,
                             const StillSurface& b, bool of_a)
{
    const StillSurface &mine = of_a ? a : b, &other = of_a ? b : a;
    const SurfaceTopology& surface = mine.topology;
    std::vector<bool> is_pierced(surface.edges().size());
    for (const Piercing& piercing : piercings)
        if (piercing.edge_of_a == of_a)
            is_pierced[piercing.edge] = true;

    SurfaceRegions regions{std::vector<int>(static_cast<std::size_t>(surface.vertex_count()), -1), {}};
    for (int first = 0; first < surface.vertex_count(); ++first) {
        if (regions.region_of_vertex[first] >= 0)
            continue;
        const int region = static_cast<int>(regions.winding.size());
        regions.winding.push_back(winding_by_ray(mine.positions[first], other, of_a ? 1 : -1));
        regions.region_of_vertex[first] = region;
        std::vector<int> reached{first};
        for (std::size_t i = 0; i < reached.size(); ++i)
            for (const int edge : surface.edges_around_vertex(reached[i])) {
                const auto [v0, v1] = surface.edges()[edge];
                const int neighbour = v0 == reached[i] ? v1 : v0;
                if (is_pierced[edge] || regions.region_of_vertex[neighbour] >= 0)
                    continue;
                regions.region_of_vertex[neighbour] = region;
                reached.push_back(neighbour);
            }
    }
    return regions;
}
//! [flood_regions]

}  // namespace enduring
