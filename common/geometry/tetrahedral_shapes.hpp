#pragma once

#include "common/geometry/meshes.hpp"

#include <array>

namespace enduring {

/// Solids made by code, filled with tetrahedra. Lengths in metres; y points up; every closed surface is
/// manifold and faces outwards. All of them throw InputError for a size that is not positive and finite, a
/// count below 1 (or absurdly large), or an angle outside its range, naming the argument.

/// How the cells of a bar are cut into tetrahedra. Both ways the diagonals of neighbouring cells agree.
enum class CellSplit {
    /// six tetrahedra around the cell's diagonal: all cells alike, but a bar of linear elements moves
    /// sideways when it bends
    six,
    /// a middle one and four corners, mirrored from cell to cell: no preferred direction over two cells
    five
};

/// A cuboid around the origin, filled with a regular grid of cells that are cut into tetrahedra.
/// @param size   edge lengths along x, y, z [m]
/// @param cells  cells along x, y, z
TetrahedralMesh bar(const Vec3& size, std::array<int, 3> cells, CellSplit split = CellSplit::five);

}  // namespace enduring
