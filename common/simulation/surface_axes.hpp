#pragma once

#include "common/geometry/vector.hpp"

#include <optional>

namespace enduring {

/// Orthonormal axes that turn with a pair's two sides (PairInstant), as columns: the bisector of the sides,
/// the normal, and what is at right angles to both. Neither side counts more than the other.
/// @return  none where the sides span no plane
std::optional<Mat3> surface_axes(const Vec3& side_1, const Vec3& side_2);

}  // namespace enduring
