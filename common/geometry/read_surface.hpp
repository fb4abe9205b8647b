#pragma once

#include "common/geometry/meshes.hpp"

#include <filesystem>
#include <string>

namespace enduring {

/// Reads the triangles of a surface, by the ending of the file's name, in small or capital letters: .obj
/// (read_obj()), .off, .stl (text and binary) or .ply (text, and binary of both orders of bytes). Polygons,
/// also with dents, are cut into triangles; what is neither vertex nor face is passed over, and so are
/// vertices that no face uses. Units are taken as they stand.
///
/// These readers are our own, and not Assimp's (5.2): a broken PLY file of 200 bytes keeps it busy for ever,
/// it has single precision, and its messages name no line.
///
/// @throws InputError  "file: reason", and "file:line: reason" where the file is text: missing, empty or
///     broken file, another ending, no faces, a coordinate that is not finite, a face with fewer than three
///     corners or with a vertex that does not exist, a polygon that cannot be cut into triangles, more
///     entries promised than there are
SurfaceMesh read_surface(const std::filesystem::path& file);

/// The same from the bytes of a file.
/// @param name  of the file, for messages
SurfaceMesh read_off(const std::string& bytes, const std::string& name);
/// An STL file has three vertices of its own for each triangle: those with equal coordinates become one.
SurfaceMesh read_stl(const std::string& bytes, const std::string& name);
SurfaceMesh read_ply(const std::string& bytes, const std::string& name);

/// The ending of a file's name in small letters: ".stl" of "PART.STL".
std::string ending_of(const std::filesystem::path& file);

}  // namespace enduring
