#include "chapters/09_deep_contacts/surface_regions.hpp"

namespace enduring {
namespace {

/// Of each edge: how many faces pierce it, and by how much its larger vertex is wound around more.
struct EdgePiercings {
    int count = 0, gain = 0;
};

std::vector<EdgePiercings> piercings_of_edges(const std::vector<Piercing>& piercings, bool of_a,
                                              std::size_t edges)
{
    std::vector<EdgePiercings> all(edges);
    for (const Piercing& piercing : piercings)
        if (piercing.edge_of_a == of_a) {
            EdgePiercings& edge = all[piercing.edge];
            ++edge.count;
            edge.gain += piercing.entry;
        }
    return all;
}

/// Calls visit(neighbour, piercings of the edge, gain of winding on the path there).
template <class Visit>
void visit_neighbours(const SurfaceTopology& surface, const std::vector<EdgePiercings>& edges, int vertex,
                      Visit&& visit)
{
    for (const int edge : surface.edges_around_vertex(vertex)) {
        const auto [v0, v1] = surface.edges()[edge];
        const EdgePiercings& pierced = edges[edge];
        visit(v0 == vertex ? v1 : v0, pierced.count, v0 == vertex ? pierced.gain : -pierced.gain);
    }
}

//! [flood]
/// All vertices that can be reached from one, each with how often it is wound around; `reach(piercings of an
/// edge)` says whether an edge may be passed.
template <class Reach>
std::vector<int> flood(const SurfaceTopology& surface, const std::vector<EdgePiercings>& edges, int first,
                       std::vector<int>& mark, int with, std::vector<int>& winding, const Reach& reach)
{
    std::vector<int> reached{first};
    mark[first] = with;
    for (std::size_t i = 0; i < reached.size(); ++i)
        visit_neighbours(surface, edges, reached[i], [&](int neighbour, int count, int gain) {
            if (mark[neighbour] >= 0 || !reach(count))
                return;
            mark[neighbour] = with;
            winding[neighbour] = winding[reached[i]] + gain;
            reached.push_back(neighbour);
        });
    return reached;
}
//! [flood]

}  // namespace

//! [flood_regions]
SurfaceRegions flood_regions(const std::vector<Piercing>& piercings, const StillSurface& a,
                             const StillSurface& b, bool of_a)
{
    const StillSurface &mine = of_a ? a : b, &other = of_a ? b : a;
    const SurfaceTopology& surface = mine.topology;
    const auto edges = piercings_of_edges(piercings, of_a, surface.edges().size());
    const auto count = static_cast<std::size_t>(surface.vertex_count());
    std::vector<int> part(count, -1), winding(count, 0);
    for (int vertex = 0; vertex < surface.vertex_count(); ++vertex)
        if (part[vertex] < 0) {
            winding[vertex] = winding_by_ray(mine.positions[vertex], other, of_a ? 1 : -1);
            flood(surface, edges, vertex, part, vertex, winding, [](int) { return true; });
        }

    SurfaceRegions regions{std::vector<int>(count, -1), {}, true};
    for (int vertex = 0; vertex < surface.vertex_count(); ++vertex) {
        if (regions.region_of_vertex[vertex] < 0) {
            const int region = static_cast<int>(regions.winding.size());
            regions.winding.push_back(winding[vertex]);
            flood(surface, edges, vertex, regions.region_of_vertex, region, winding,
                  [](int pierced) { return pierced == 0; });
        }
        visit_neighbours(surface, edges, vertex, [&](int neighbour, int, int gain) {
            regions.consistent = regions.consistent && winding[neighbour] == winding[vertex] + gain;
        });
    }
    return regions;
}
//! [flood_regions]

}  // namespace enduring
