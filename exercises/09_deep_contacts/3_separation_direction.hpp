#pragma once

#include "common/geometry/vector.hpp"

#include <optional>
#include <vector>

namespace enduring {

/// A closed curve of straight pieces: its points in order [m]; the last one is joined to the first. It bounds
/// the part of A's surface that is inside B, and has it to its left, seen from outside of A.
using Loop = std::vector<Vec3>;

/// The integral of A's normals over the part that the loop bounds [m^2]. Zero for fewer than three points.
Vec3 vector_area(const Loop& loop);

/// The direction in which A leaves B so that the volume that they share shrinks fastest: unit length. None if
/// there is no loop, or if the loops' vector areas cancel: if what is left is less than `cancelled` of what
/// they are summed from.
///
/// @param cancelled  a pure number
std::optional<Vec3> separation_direction(const std::vector<Loop>& loops, double cancelled = 1e-3);

/// The integral of (x - centre) cross normal over the part of A's surface that the loop bounds [m^3]. If A
/// turns about `centre` by a small angle phi [rad, a vector along the axis], the shared volume grows by phi
/// times this.
Vec3 turning(const Loop& loop, const Vec3& centre);

}  // namespace enduring
