#pragma once

#include "common/geometry/meshes.hpp"

#include <vector>

namespace enduring {

/// The surface of a solid mesh, and which node each of its vertices is.
struct ExtractedSurface {
    SurfaceMesh mesh;
    std::vector<int> nodes;  ///< node of the solid mesh for each surface vertex, ascending
};

/// The faces that belong to one element only, outwards; in the order of the elements.
ExtractedSurface surface_of(const TetrahedralMesh& mesh);

/// As above; each face of a 10-node element becomes four triangles over its six
/// nodes: three at the corners, one in the middle.
ExtractedSurface surface_of(const QuadraticTetrahedralMesh& mesh);

/// Faces of a solid mesh that more than two elements claim (corner nodes, ascending): none in a sound mesh.
std::vector<std::array<int, 3>> faces_of_three_elements(const TetrahedralMesh& mesh);

}  // namespace enduring
