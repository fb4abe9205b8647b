#pragma once

#include "common/geometry/surface_topology.hpp"
#include "common/geometry/vector.hpp"

#include <span>
#include <utility>
#include <vector>

namespace enduring {

/// Which features of one surface are never in contact with each other: those with a common vertex, and those
/// that lie so near in the rest shape that the elements between them have to keep them apart.
///
/// Two vertices are so near if no more than the longer of the longest edges at them lies between them at
/// rest, and if it is the body that lies between: along the edges of its elements the way is no more than
/// twice as long. So the strands of a knot, which are near each other through the air, are none. Two
/// features are neighbours if any two of their vertices are. So the distance follows the mesh, wherever it
/// is coarse or fine: to bring such features together, the surface would have to fold within two of its
/// triangles. A number of rings would do as well on a surface, but not through a thin wall, whose two sides
/// are many edges apart.
class RestNeighbours {
public:
    /// @param surface  outlives it
    /// @param rest     where all nodes lie while nothing is strained, the surface's vertices first [m]
    /// @param bonds    edges of the elements, between two nodes each
    RestNeighbours(const SurfaceTopology& surface, std::span<const Vec3> rest,
                   std::span<const std::pair<int, int>> bonds);

    bool vertex_and_face(int vertex, int face) const;
    bool edges(int edge, int other) const;
    bool edge_and_face(int edge, int face) const;

private:
    bool vertices(int u, int v) const;

    const SurfaceTopology& surface_;
    std::vector<std::vector<int>> near_;  ///< of each vertex: the larger ones that are so near, ascending
};

class Body;

/// Of a body that meets itself; none for all others.
const RestNeighbours* rest_neighbours(const Body& body);

}  // namespace enduring
