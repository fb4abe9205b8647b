#pragma once

#include "common/geometry/tetrahedral_shapes.hpp"

#include <functional>

namespace enduring::chapter10 {

/// A place on a curve, the direction to the left of it and the one that is across to both, of unit length.
struct CurvePoint {
    Vec3 place, left, up = Vec3::UnitZ();
};

/// A bar of tetrahedra that follows a curve: its thickness lies to the left, its width upwards [m].
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

/// Around the z axis; its ends are one.
TetrahedralMesh ring(double radius, double thickness, double width, std::array<int, 3> cells);

/// Two legs of 20 cm and a half circle of 2 cm. Their ends, 1 cm thick, are so far apart [m].
TetrahedralMesh hairpin(double gap, std::array<int, 3> cells);

/// A bar that leads through itself: two legs of 20 cm that cross at a right angle, joined by three quarters
/// of a circle.
TetrahedralMesh crossed_bar(double thickness, double width, std::array<int, 3> cells);

/// A rope, square across, with a loose overhand knot around the z axis, from which its ends lead to the left
/// and to the right: a trefoil whose lowest loop is cut.
/// @param size  of the knot, from its middle to the top of a loop [m]
/// @param arm   length of each straight end [m]
TetrahedralMesh overhand_knot(double size, double arm, double thickness, int cells);

}  // namespace enduring::chapter10
