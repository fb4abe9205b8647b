#include "exercises/05_categorisation/2_cone.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace enduring {

static double widest_angle(const Vec3& axis, std::span<const Vec3> normals)
{
    double least_cosine = 1;
    for (const Vec3& normal : normals)
        least_cosine = std::min(least_cosine, axis.dot(normal));
    return std::acos(std::clamp(least_cosine, -1.0, 1.0));
}

Cone smallest_cone(std::span<const Vec3> normals)
{
    not_implemented_yet("5.2");
}

bool cone_says_regular(std::span<const Vec3> normals, const Vec3& contact_normal)
{
    not_implemented_yet("5.2");
}

}  // namespace enduring
