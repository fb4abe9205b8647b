// A second way: no list of candidates. The axis walks towards the direction that is farthest from it, in ever
// smaller steps (Badoiu and Clarkson's idea for balls).
#include "exercises/05_categorisation/2_cone.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring {

static const Vec3& farthest(const Vec3& axis, std::span<const Vec3> normals)
{
    return *std::min_element(normals.begin(), normals.end(),
                             [&](const Vec3& a, const Vec3& b) { return a.dot(axis) < b.dot(axis); });
}

Cone smallest_cone(std::span<const Vec3> normals)
{
    Vec3 axis = normals[0];
    for (int i = 1; i < 20000; ++i)
        axis = (axis + (farthest(axis, normals) - axis) / (i + 1)).normalized();
    return {axis, std::acos(std::clamp(axis.dot(farthest(axis, normals)), -1.0, 1.0))};
}

bool cone_says_regular(std::span<const Vec3> normals, const Vec3& contact_normal)
{
    const Cone cone = smallest_cone(normals);
    return std::atan2(cone.axis.cross(contact_normal).norm(), -cone.axis.dot(contact_normal)) <=
           cone.half_angle + std::numbers::pi / 4;
}

}  // namespace enduring
