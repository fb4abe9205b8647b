#pragma once

#include "common/geometry/gmsh_groups.hpp"
#include "common/geometry/meshes.hpp"

#include <filesystem>
#include <istream>
#include <string>

namespace enduring {

/// Reads the tetrahedra of a Gmsh file, version 2.2 or 4.1, text or binary: element type 4, or the corners of
/// type 11.
///
/// Points, lines and surface elements are passed over, but for the physical groups that they mark, and so are
/// nodes that no tetrahedron uses; the others keep their order in the file. Units are taken as they stand.
///
/// @throws InputError  "file:line: reason", of a binary file "file, byte N: reason" or with the line of the
///                     text that holds the same: missing, empty or truncated file, another version, a number
///                     that is not finite or not a number, a node that is named twice or does not exist, an
///                     inverted or flat element, no tetrahedra, another kind of solid element, or both kinds
///                     of tetrahedra
TetrahedralMesh read_gmsh(const std::filesystem::path& file);
TetrahedralMesh read_gmsh(std::istream& stream, const std::string& name);

/// The same, with the nodes of each physical group that has a name.
struct GmshSolid {
    TetrahedralMesh mesh;
    NodeGroups groups;
};
GmshSolid read_gmsh_with_groups(const std::filesystem::path& file);
GmshSolid read_gmsh_with_groups(std::istream& stream, const std::string& name);

/// The same with 10 nodes an element: type 11 as it stands, type 4 with the middles of its edges added.
QuadraticTetrahedralMesh read_gmsh_quadratic(const std::filesystem::path& file);
QuadraticTetrahedralMesh read_gmsh_quadratic(std::istream& stream, const std::string& name);

}  // namespace enduring
