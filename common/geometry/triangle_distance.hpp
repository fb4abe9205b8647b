#pragma once

#include "common/geometry/vector.hpp"

namespace enduring {

/// Distance from a point to a triangle with an area, its border included [m].
double distance_to_triangle(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace enduring
