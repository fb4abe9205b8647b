#pragma once

#include "chapters/09_deep_contacts/piercing.hpp"

namespace enduring {

/// The parts into which the curves of an intersection cut the vertices of one surface.
struct SurfaceRegions {
    std::vector<int> region_of_vertex;
    /// of each region: how often the other surface winds around it, 1 inside and 0 outside
    std::vector<int> winding;

    int winding_of_vertex(int vertex) const { return winding[region_of_vertex[vertex]]; }
};

/// Floods a surface from vertex to vertex along the edges that nothing pierces: that is a region. Its first vertex asks
/// with a ray on which side all of them lie.
/// @param piercings    of A and B, from find_piercings
/// @param of_a         whether the regions of A are wanted, else those of B
/// @see Baraff, Witkin and Kass 2003, "Untangling cloth"
SurfaceRegions flood_regions(const std::vector<Piercing>& piercings, const StillSurface& a,
                             const StillSurface& b, bool of_a);

}  // namespace enduring
