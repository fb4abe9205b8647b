#pragma once

#include "common/geometry/gmsh_groups.hpp"
#include "common/geometry/meshes.hpp"
#include "common/geometry/surface_checks.hpp"
#include "common/input/json_value.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace enduring {

/// What a scene file may ask for; a fuzzer asks for less.
struct SceneLimits {
    int surface_faces = 1'000'000;  ///< of one generated surface
    int elements = 300'000;         ///< of one generated bar
    std::size_t bodies = 100'000;
};

/// Where a scene's words lead: folders that are searched for meshes, in this order, and the limits.
struct SceneSurroundings {
    std::vector<std::filesystem::path> mesh_folders;
    SceneLimits limits{};
    std::vector<std::string>* told = nullptr;  ///< is given a sentence on each surface that was mended
};

/// A shape in its own coordinates, scaled and transformed, not yet placed: a surface,
/// and the solid inside it where there is one. Points and edges alone are a surface without faces.
struct Shape {
    SurfaceMesh surface;
    std::optional<TetrahedralMesh> solid;
    NodeGroups groups{};  ///< of the solid, by their names in its file
};

/// Reads {"box": {...}}, {"file": "part.stl", "scale": 0.001, "weld": true, "mend": true} and the other
/// shapes of the scene format. The one who knows whether it may have a border mends it (mend_if_asked()).
/// @throws InputError  anything the format does not allow, with the JSON path
Shape read_shape(const JsonValue& value, const SceneSurroundings& surroundings);

/// A mesh file that a scene names.
/// @throws InputError  there is none in these folders
std::filesystem::path find_mesh(const JsonValue& value, const std::vector<std::filesystem::path>& folders);

/// "mend": true, beside a "file" that is a surface.
SurfaceMesh mend_if_asked(const JsonValue& shape, SurfaceMesh mesh, Border border,
                          const SceneSurroundings& surroundings);

}  // namespace enduring
