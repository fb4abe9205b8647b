#pragma once

#include "common/geometry/meshes.hpp"

#include <filesystem>
#include <istream>
#include <string>

namespace enduring {

/// Reads the triangles of a Wavefront OBJ file; polygons, also with dents, are cut
/// into triangles. Everything but vertices and faces is passed over, and so are
/// vertices that no face uses. Units are taken as they stand.
///
/// @throws InputError  "file:line: reason": missing, empty or binary file, a coordinate that is not a finite
///                     number, a face with fewer than three corners or with a vertex that does not exist, a
///                     polygon that cannot be cut into triangles, no faces
SurfaceMesh read_obj(const std::filesystem::path& file);
SurfaceMesh read_obj(std::istream& stream, const std::string& name);

/// Reads points and edges alone of such a file: all its vertices, and the edges of its lines ("l 1 2 3" has
/// two of them).
///
/// @throws InputError  "file:line: reason": as above, and a face, a line with one vertex or with a vertex
///                     that does not exist, no vertices, more than `most` of them or of edges
SurfaceMesh read_obj_frame(const std::filesystem::path& file, int most);
SurfaceMesh read_obj_frame(std::istream& stream, const std::string& name, int most);

}  // namespace enduring
