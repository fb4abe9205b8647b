#pragma once

#include "common/geometry/surface_topology.hpp"
#include "common/geometry/vector.hpp"

#include <array>
#include <vector>

namespace enduring {

/// A triangle surface as read or generated: positions [m] and faces, counter-clockwise seen from outside.
/// Without faces it is a wire frame, or without edges, too, a cloud of points.
struct SurfaceMesh {
    std::vector<Vec3> vertices;
    std::vector<Face> faces;
    std::vector<Edge> wires{};  ///< only where there are no faces
};

/// @throws InputError  as SurfaceTopology does
inline SurfaceTopology topology_of(const SurfaceMesh& mesh)
{
    const auto vertices = static_cast<int>(mesh.vertices.size());
    return mesh.faces.empty() ? SurfaceTopology::of_edges(vertices, mesh.wires)
                              : SurfaceTopology(vertices, mesh.faces);
}

/// A tetrahedral mesh with 4 nodes an element: positions [m]; the first three nodes of a tetrahedron run
/// counter-clockwise seen from the fourth, so that det(x1-x0, x2-x0, x3-x0) > 0.
struct TetrahedralMesh {
    std::vector<Vec3> nodes;
    std::vector<std::array<int, 4>> elements;
};

/// A tetrahedral mesh with 10 nodes an element: four corners, then the middles of the edges
/// 01, 12, 02, 03, 13, 23 of those corners, in this order. The first `corner_count` nodes are the corners.
struct QuadraticTetrahedralMesh {
    std::vector<Vec3> nodes;
    std::vector<std::array<int, 10>> elements;
    int corner_count = 0;
};

/// The corners of each edge of a tetrahedron, in the order of the 10-node element.
inline constexpr std::array<std::array<int, 2>, 6> tetrahedron_edges{
    {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}}};

/// The corners of each face of a tetrahedron, counter-clockwise seen
/// from outside; face i lies opposite corner i.
inline constexpr std::array<std::array<int, 3>, 4> tetrahedron_faces{
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

}  // namespace enduring
