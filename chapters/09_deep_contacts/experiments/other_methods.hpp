#pragma once

#include "chapters/09_deep_contacts/overlaps.hpp"

namespace enduring::chapter09 {

/// The separation direction of each of some vertices that lie in another surface, unit length; zero for none.
/// @param separation_direction  of the overlap that they belong to
using SeparationMethod = std::vector<Vec3>(const StillSurface& inner, const std::vector<int>& vertices,
                                           const StillSurface& outer, const Vec3& separation_direction);

/// All vertices share the direction of their overlap.
std::vector<Vec3> overlap_direction(const StillSurface& inner, const std::vector<int>& vertices,
                                    const StillSurface& outer, const Vec3& separation_direction);

/// Carries direction and depth from the border of the overlap inwards: at the border the normals of the faces
/// that are pierced next to a vertex, each with the inverse of its squared distance, and from there from
/// neighbour to neighbour. A vertex that the border does not reach gets none.
/// @see Heidelberger et al. 2004, "Consistent penetration depth estimation for deformable collision response"
std::vector<Vec3> directions_from_the_border(const StillSurface& inner, const std::vector<int>& vertices,
                                             const StillSurface& outer, const Vec3& separation_direction);

/// The shortest path to the boundary that stays inside. A body that does not cross itself lets every vertex
/// go straight to the nearest point of its surface; the search through tetrahedra is for those that do.
/// @see Chen et al. 2023, "Shortest path to boundary for self-intersecting meshes"
std::vector<Vec3> directions_to_the_boundary(const StillSurface& inner, const std::vector<int>& vertices,
                                             const StillSurface& outer, const Vec3& separation_direction);

}  // namespace enduring::chapter09
