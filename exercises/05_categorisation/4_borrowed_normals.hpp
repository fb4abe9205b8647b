#pragma once

#include "common/geometry/surface_topology.hpp"
#include "common/simulation/contact.hpp"

#include <optional>
#include <span>
#include <vector>

namespace enduring {

/// What a solver knows of one vertex that lies inside another body.
struct BuriedVertex {
    int vertex;
    Vec3 normal;  ///< of its pair, unit length
    ContactCategory category;
};

/// A normal for each buried vertex, in their order: a regular one keeps its own; a hooked one borrows the
/// mean of the normals of the nearest regular ones, made a unit vector, where near is counted in edges of the
/// surface, over buried vertices only.
///
/// @param surface  of the body whose vertices are buried
/// @param buried   each vertex once
/// @return         nothing for a hooked vertex from which no regular one can be
///     reached, or where the borrowed normals cancel
/// @see Heidelberger et al. 2004, "Consistent penetration depth
///     estimation", for the idea of passing normals on
std::vector<std::optional<Vec3>> borrowed_normals(const SurfaceTopology& surface,
                                                  std::span<const BuriedVertex> buried);

}  // namespace enduring
