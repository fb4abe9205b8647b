#pragma once

#include "common/geometry/meshes.hpp"

namespace enduring {

/// The same straight-sided tetrahedra with 10 nodes each: corners keep their numbers, the middles of the
/// edges follow in ascending order of their (smaller, larger) corner.
QuadraticTetrahedralMesh with_edge_midpoints(const TetrahedralMesh& mesh);

/// The 4-node tetrahedra between the corners.
TetrahedralMesh corners_of(const QuadraticTetrahedralMesh& mesh);

}  // namespace enduring
