#pragma once

#include "common/geometry/meshes.hpp"

namespace enduring {

/// Round surfaces made by code. Lengths in metres; y points up; every closed surface is manifold and faces
/// outwards. All of them throw InputError for a size that is not positive and finite, a count below 1 (or
/// absurdly large), or an angle outside its range, naming the argument.

/// A regular tetrahedron standing on a face, its centroid at the origin.
SurfaceMesh tetrahedron(double edge_length);

/// An icosahedron refined `subdivisions` times and pushed onto the sphere
/// around the origin: 20 * 4^subdivisions faces.
/// @param subdivisions  in [0, 8]
SurfaceMesh sphere(double radius, int subdivisions = 2);

/// A torus around the origin that lies flat: its axis is y.
/// @param radius       from the axis to the middle of the tube [m]
/// @param tube_radius  [m], below `radius`
/// @param around       segments about the axis, at least 3
/// @param across       segments of the tube's section, at least 3
SurfaceMesh torus(double radius, double tube_radius, int around = 16, int across = 8);

/// A thick part of a spherical shell that opens upwards, with a rounded
/// rim and, if wanted, a flat foot to stand on.
struct BowlShape {
    double inner_radius = 1.0;  ///< of the hollow [m]
    double thickness = 0.1;     ///< of the wall [m]
    /// from straight down to the middle of the rim, seen from the centre [rad], in (0, pi)
    double rim_angle = 1.4;
    /// [m], in [0, sqrt(R^2 - r^2)) with the outer radius R and the inner r; 0 leaves it round
    double foot_radius = 0.0;
    int segments_around = 32;  ///< at least 3
    int segments_along = 12;   ///< of the wall, from the bottom to the rim, at least 2
    int segments_rim = 4;      ///< of the half circle that rounds the rim, at least 2
};

/// The bowl as a surface of revolution about y; the origin is the centre of the spheres.
SurfaceMesh bowl(const BowlShape& shape);

}  // namespace enduring
