#pragma once

#include "chapters/09_deep_contacts/piercing.hpp"

namespace enduring {

/// The parts into which the curves of an intersection cut the vertices of one surface.
struct SurfaceRegions {
    std::vector<int> region_of_vertex;
    /// of each region: how often the other surface winds around it, 1 inside and 0 outside
    std::vector<int> winding;
    /// every edge of the surface says the same as the regions at its ends: so it is if all curves are closed
    bool consistent = true;

    int winding_of_vertex(int vertex) const { return winding[region_of_vertex[vertex]]; }
};

/// Floods a surface from vertex to vertex along the edges that nothing pierces: that is a region. Over a
/// pierced edge the winding changes by the piercings' signs. Each part of the surface that hangs together
/// asks for one vertex with a ray, and for no other.
/// @param piercings    of A and B, from find_piercings
/// @param of_a         whether the regions of A are wanted, else those of B
/// @see Baraff, Witkin and Kass 2003, "Untangling cloth"
SurfaceRegions flood_regions(const std::vector<Piercing>& piercings, const StillSurface& a,
                             const StillSurface& b, bool of_a);

}  // namespace enduring
