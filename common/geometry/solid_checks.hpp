#pragma once

#include "common/geometry/meshes.hpp"

#include <string>

namespace enduring {

/// Checks a solid mesh: node indices, finite nodes that are all in use, elements neither inverted nor flat,
/// no face of more than two elements, and a surface that passes check_surface.
/// @throws InputError  "what: reason", naming the element or node (counted from 0)
void check_solid(const TetrahedralMesh& mesh, const std::string& what);
void check_solid(const QuadraticTetrahedralMesh& mesh, const std::string& what);

}  // namespace enduring
