#pragma once

#include "common/geometry/meshes.hpp"

namespace enduring {

/// The same surface with one vertex for all that coincide: those not further than `distance` from the first
/// of them, in the order of the mesh. Faces of which two corners become one are dropped, and so are vertices
/// that no face names.
/// @param mesh      finite vertices; faces name existing ones
/// @param distance  [m], not negative; 0 for equal coordinates only
SurfaceMesh welded(const SurfaceMesh& mesh, double distance);

/// Of the distance of two vertices that a file means as one to the size of its surface: files hold six digits
/// or more; ten times as much joins neighbours of the finest scans, and a tenth leaves cracks in what was
/// written in single precision.
inline constexpr double same_vertex = 1e-6;

/// That distance, with the diagonal of the surface's bounding box for its size [m].
double weld_distance(const SurfaceMesh& mesh);

}  // namespace enduring
