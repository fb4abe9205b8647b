#include "exercises/05_categorisation/2_cone.hpp"

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
    // The narrowest cone touches one, two or three of the directions; its axis is as far from each of them.
    std::vector<Vec3> axes(normals.begin(), normals.end());
    for (std::size_t i = 0; i < normals.size(); ++i)
        for (std::size_t j = i + 1; j < normals.size(); ++j) {
            axes.push_back(normals[i] + normals[j]);
            for (std::size_t k = j + 1; k < normals.size(); ++k) {
                const Vec3 equidistant = (normals[j] - normals[i]).cross(normals[k] - normals[i]);
                axes.push_back(equidistant.dot(normals[i]) < 0 ? Vec3(-equidistant) : equidistant);
            }
        }
    Cone best{Vec3::Zero(), 4};
    for (Vec3& axis : axes) {
        if (axis.norm() < 1e-9)
            continue;
        axis.normalize();
        if (const double angle = widest_angle(axis, normals); angle < best.half_angle)
            best = {axis, angle};
    }
    return best;
}

bool cone_says_regular(std::span<const Vec3> normals, const Vec3& contact_normal)
{
    const Cone cone = smallest_cone(normals);
    const double from_the_axis = std::acos(std::clamp(-cone.axis.dot(contact_normal), -1.0, 1.0));
    return from_the_axis <= cone.half_angle + std::numbers::pi / 4;
}

}  // namespace enduring
