#pragma once

#include "common/geometry/vector.hpp"

#include <array>
#include <string>

namespace enduring {

/// Signed volume of a tetrahedron [m^3], positive for our order of corners.
double signed_volume(const std::array<Vec3, 4>& corners);

/// Why an element cannot be used, as the end of a sentence ("is inverted: ..."); empty if it can.
///
/// A 4-node element needs a volume above 1e-12 of the cube of its longest edge. A 10-node element also needs
/// a positive determinant of its map's derivative at all ten nodes.
std::string element_fault(const std::array<Vec3, 4>& nodes);
std::string element_fault(const std::array<Vec3, 10>& nodes);

/// The smallest angle between two faces of a tetrahedron [rad]; 0 if it is flat.
double smallest_dihedral_angle(const std::array<Vec3, 4>& corners);

}  // namespace enduring
