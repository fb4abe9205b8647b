#pragma once

#include "common/geometry/meshes.hpp"

#include <string>

namespace enduring {

/// Volume inside a closed surface [m^3], by the divergence theorem; negative if it faces inwards.
double enclosed_volume(const SurfaceMesh& mesh);

/// The same surface without the vertices that no face names; the others keep their order.
SurfaceMesh without_unused_vertices(const SurfaceMesh& mesh);

/// Whether a surface may have a border. What asks for an inside refuses it.
enum class Border { refused, allowed };

/// Checks that contact can live on this surface: vertices finite and all in use, faces
/// with an area and no face twice, manifold, neighbours facing the same way; and,
/// unless a border is allowed, closed and facing outwards.
/// @param what   names the mesh in the message, e.g. its file
/// @param nodes  of a solid's surface: which of the solid's nodes each vertex is. Then messages name nodes,
///               and no faces, whose numbers nobody knows
/// @throws InputError  "what: reason", naming the vertex, face or edge (counted from 0)
void check_surface(const SurfaceMesh& mesh, const std::string& what, Border border = Border::refused,
                   const std::vector<int>& nodes = {});

}  // namespace enduring
