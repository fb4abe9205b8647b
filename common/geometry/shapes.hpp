#pragma once

#include "common/geometry/meshes.hpp"

#include <array>

namespace enduring {

/// Shapes made by code. Lengths in metres; y points up; every closed surface is manifold and faces outwards.
/// All of them throw InputError for a size that is not positive and finite, a count below 1 (or absurdly large),
/// or an angle outside its range, naming the argument.

/// A cuboid around the origin; each side is a grid of cells, each cell two triangles.
/// @param size   edge lengths along x, y, z [m]
/// @param cells  cells along x, y, z
SurfaceMesh box(const Vec3& size, std::array<int, 3> cells = {1, 1, 1});

/// A thick slab whose upper side passes through the origin and rises towards +x.
/// @param size   length along the slope, thickness, width along z [m]
/// @param angle  of the slope against the horizontal [rad], in (-pi/2, pi/2)
/// @param cells  along the same three directions
SurfaceMesh slope(const Vec3& size, double angle, std::array<int, 3> cells = {1, 1, 1});

/// How the cells of a plane grid are cut into triangles.
enum class GridDiagonals {
    same,         ///< every cell along the same diagonal
    alternating,  ///< neighbours along different diagonals, as on a chessboard
    crossed       ///< both diagonals, with a vertex in the middle of each cell (union jack)
};

/// An open, flat grid in the plane y = 0 around the origin, facing up.
/// @param size_x, size_z  edge lengths [m]
/// @param cells           along x and z
SurfaceMesh plane_grid(double size_x, double size_z, std::array<int, 2> cells, GridDiagonals diagonals = GridDiagonals::same);

/// A regular tetrahedron standing on a face, its centroid at the origin.
SurfaceMesh tetrahedron(double edge_length);

/// An icosahedron refined `subdivisions` times and pushed onto the sphere around the origin: 20 * 4^subdivisions faces.
/// @param subdivisions  in [0, 8]
SurfaceMesh sphere(double radius, int subdivisions = 2);

/// A thick part of a spherical shell that opens upwards, with a rounded rim and, if wanted, a flat foot to stand on.
struct BowlShape {
    double inner_radius = 1.0;   ///< of the hollow [m]
    double thickness = 0.1;      ///< of the wall [m]
    double rim_angle = 1.4;      ///< from straight down to the middle of the rim, seen from the centre [rad], in (0, pi)
    double foot_radius = 0.0;    ///< [m], in [0, sqrt(R^2 - r^2)) with the outer radius R and the inner r; 0 leaves it round
    int segments_around = 32;    ///< at least 3
    int segments_along = 12;     ///< of the wall, from the bottom to the rim, at least 2
    int segments_rim = 4;        ///< of the half circle that rounds the rim, at least 2
};

/// The bowl as a surface of revolution about y; the origin is the centre of the spheres.
SurfaceMesh bowl(const BowlShape& shape);

/// How the cells of a bar are cut into tetrahedra. Both ways the diagonals of neighbouring cells agree.
enum class CellSplit {
    six,  ///< six tetrahedra around the cell's diagonal: all cells alike, but the bar twists a little when it bends
    five  ///< a middle one and four corners, mirrored from cell to cell: no preferred direction over two cells
};

/// A cuboid around the origin, filled with a regular grid of cells that are cut into tetrahedra.
/// @param size   edge lengths along x, y, z [m]
/// @param cells  cells along x, y, z
TetrahedralMesh bar(const Vec3& size, std::array<int, 3> cells, CellSplit split = CellSplit::six);

}  // namespace enduring
