#pragma once

#include "common/geometry/vector.hpp"

#include <array>
#include <vector>

namespace enduring {

/// A soft body. Its first vertices are those of its surface, and the others lie inside.
struct SoftShape {
    std::vector<Vec3> rest;                 ///< where each vertex lies while nothing is strained [m]
    std::vector<Vec3> now;                  ///< and where it lies now [m]
    int surface_vertices = 0;               ///< how many of them the surface has
    std::vector<std::array<int, 3>> faces;  ///< of the surface
    std::vector<std::array<int, 2>> edges;  ///< of the surface
    std::vector<std::array<int, 2>> bonds;  ///< edges of all elements, those of the surface among them
};

/// How far it is at rest from one vertex to each of all vertices, inside ones too, along the bonds [m]; INFINITY where no
/// bonds lead.
std::vector<double> paths_from(const SoftShape& shape, int vertex);

/// table[u][v] of the surface's vertices: whether u and v are neighbours.
using Neighbours = std::vector<std::vector<bool>>;

/// Two vertices of the surface are neighbours if, at rest,
/// - the straight line between them is no longer than the longest edge of the surface that ends at one of the two, and
/// - the path along the bonds is no longer than twice the longest edge of the surface.
/// Each vertex is a neighbour of itself.
Neighbours find_neighbours(const SoftShape& shape);

/// Pairs of features of one surface, each an index into its list.
struct OwnPairs {
    std::vector<std::array<int, 2>> vertex_face;
    std::vector<std::array<int, 2>> edge_edge;  ///< the smaller edge first
};

/// The pairs of features that lie near each other now and may push: each once, both lists ascending. Two features are
/// near if the boxes around them, each larger by the margin on all sides, have a point in common. They may not push if
/// some vertex of the one is a neighbour of some vertex of the other.
/// @param margin  [m]
OwnPairs find_own_pairs(const SoftShape& shape, const Neighbours& neighbours, double margin);

}  // namespace enduring
