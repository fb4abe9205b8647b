#pragma once

#include "common/geometry/meshes.hpp"
#include "common/geometry/surface_checks.hpp"

#include <string>

namespace enduring {

/// What was mended on a surface.
struct MendCounts {
    int flat_faces =
        0;  ///< without area, taken out: two corners became one, or a neighbour was cut at the middle one
    int double_faces = 0;     ///< over the same vertices as another one
    int flap_faces = 0;       ///< that hang on a closed surface and have a border
    int parted_edges = 0;     ///< that more than two faces shared
    int parted_vertices = 0;  ///< new ones, where parts met in a vertex or along such edges

    /// In words for a reader; empty where nothing was mended.
    std::string text() const;
};

struct MendedSurface {
    SurfaceMesh mesh;
    MendCounts counts;
};

/// Mends what check_surface() refuses and what has one sensible answer. Where more than two faces share an
/// edge, neighbours are those that have the inside between them, so parts that touch become parts with
/// vertices of their own at the same place. What is not mended (holes, faces that face the wrong way) is left
/// for check_surface() to tell.
/// @param mesh    faces name existing vertices, which are finite
/// @param border  allowed: what hangs on an open surface is part of it, and stays
MendedSurface mended(const SurfaceMesh& mesh, Border border);

}  // namespace enduring
