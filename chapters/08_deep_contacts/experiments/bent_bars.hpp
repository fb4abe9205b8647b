#pragma once

#include "common/geometry/tetrahedral_shapes.hpp"

#include <functional>

namespace enduring::chapter08 {

/// A place on a curve in the plane z = 0 and the direction to the left of it, of unit length.
struct CurvePoint {
    Vec3 place, left;
};

/// A bar of tetrahedra that follows a curve: its thickness lies across the curve, its width along z [m].
/// @param cells  along the curve, through the thickness, over the width
/// @param curve  of the arc length, from 0 to `length`
TetrahedralMesh bent_bar(double length, double thickness, double width, std::array<int, 3> cells,
                         const std::function<CurvePoint(double)>& curve);

/// From the origin up, leaning towards +x.
/// @param tilt  [rad]
TetrahedralMesh upright_strip(double length, double thickness, double width, std::array<int, 3> cells,
                              double tilt);

/// From `inner_radius` outwards, by `pitch` a turn.
TetrahedralMesh spiral(double inner_radius, double pitch, double length, double thickness, double width,
                       std::array<int, 3> cells);

}  // namespace enduring::chapter08
