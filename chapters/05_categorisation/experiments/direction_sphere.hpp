#pragma once

#include "chapters/05_categorisation/experiments/corner.hpp"
#include "common/experiments/render/picture.hpp"
#include "common/geometry/meshes.hpp"

#include <array>

namespace enduring::chapter05 {

/// What the rules say over all directions that a corner could be pushed from; shares of areas on the sphere.
struct DirectionShares {
    double possible = 0;       ///< a flat obstacle can touch the vertex there, of all directions
    double average_finds = 0;  ///< regular by (6.1), of the possible ones; 0 when there are none
    double span_finds = 0;     ///< regular by (6.2), of the possible ones; 0 when there are none
    double span_allows = 0;    ///< regular by (6.2), of those where nothing can touch
};

/// The sphere of directions, cut into faces; each goes to one of four groups.
struct DirectionSphere {
    std::vector<Vec3> points;
    /// possible and regular, possible and hooked, only regular, neither
    std::array<std::vector<Face>, 4> groups;
    DirectionShares shares;
};

/// @param subdivisions  of the icosahedron: 20 * 4^n directions
DirectionSphere directions_around(const Corner& corner, int subdivisions);

/// The corners in a row with the normals of their spans, and below each its sphere, seen from the same side.
Picture draw(const std::vector<DirectionSphere>& spheres, const std::vector<Corner>& corners);

}  // namespace enduring::chapter05
