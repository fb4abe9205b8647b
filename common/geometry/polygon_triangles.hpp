#pragma once

#include "common/geometry/meshes.hpp"

#include <functional>
#include <string>
#include <vector>

namespace enduring {

/// Cuts a flat polygon, also one with dents, into triangles that face the same way: one ear after the other,
/// in turn around it, until three corners are left (Meisters 1975: there always is one).
/// @param corners  three or more, indices into x
/// @param faces    the triangles are appended
/// @return         whether it could be cut; a polygon that crosses itself or is not flat may have no ear
bool append_triangles(std::vector<int> corners, const std::vector<Vec3>& x, std::vector<Face>& faces);

/// A surface from polygons, each a list of vertices counted from 0; vertices that none uses are left out.
/// @param fail  throws: told of a polygon, by its place in the list, with fewer than three corners or a
///     vertex that does not exist, or that cannot be cut, and of an empty list (place -1)
SurfaceMesh surface_from_polygons(std::vector<Vec3> vertices, const std::vector<std::vector<long>>& polygons,
                                  const std::function<void(long polygon, const std::string& reason)>& fail);

}  // namespace enduring
