#pragma once

#include "common/geometry/vector.hpp"

#include <optional>
#include <vector>

namespace enduring {

/// A direction of length 1 with which all these normals (of length 1) make less than a right angle; nothing,
/// if there is none.
std::optional<Vec3> common_side(const std::vector<Vec3>& normals);

/// Whether a closed border crosses itself, seen along a direction: two of its edges that share no corner.
bool border_crosses_itself(const std::vector<Vec3>& border, const Vec3& direction);

/// Whether a piece of a surface may touch itself: it cannot, if its normals have a common side and its
/// border, seen along it, does not cross itself.
bool may_touch_itself(const std::vector<Vec3>& normals, const std::vector<Vec3>& border);

}  // namespace enduring
