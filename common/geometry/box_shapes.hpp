#pragma once

#include "common/geometry/meshes.hpp"

#include <array>

namespace enduring {

/// Flat-faced surfaces made by code. Lengths in metres; y points up; every closed surface is manifold and
/// faces outwards. All of them throw InputError for a size that is not positive and finite, a count below 1
/// (or absurdly large), or an angle outside its range, naming the argument.

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
SurfaceMesh plane_grid(double size_x, double size_z, std::array<int, 2> cells,
                       GridDiagonals diagonals = GridDiagonals::same);

}  // namespace enduring
