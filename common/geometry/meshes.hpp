#pragma once

#include "common/geometry/surface_topology.hpp"
#include "common/geometry/vector.hpp"

#include <array>
#include <vector>

namespace enduring {

/// A triangle surface as read or generated: positions [m] and faces, counter-clockwise seen from outside.
struct SurfaceMesh {
    std::vector<Vec3> vertices;
    std::vector<Face> faces;
};

/// A tetrahedral mesh with 4 nodes an element: positions [m]; the first three nodes of a tetrahedron run
/// counter-clockwise seen from the fourth's far side, so that det(x1-x0, x2-x0, x3-x0) > 0.
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

}  // namespace enduring
