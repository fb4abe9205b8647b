#include "common/geometry/triangle_distance.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

double distance_to_segment(const Vec3& point, const Vec3& a, const Vec3& b)
{
    const double along = std::clamp((point - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    return (point - a - along * (b - a)).norm();
}

}  // namespace

double distance_to_triangle(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 normal = (b - a).cross(c - a).normalized();
    const auto left_of = [&](const Vec3& from, const Vec3& to) {
        return normal.dot((to - from).cross(point - from)) >= 0;
    };
    if (left_of(a, b) && left_of(b, c) && left_of(c, a))
        return std::abs(normal.dot(point - a));
    return std::min({distance_to_segment(point, a, b), distance_to_segment(point, b, c),
                     distance_to_segment(point, c, a)});
}

}  // namespace enduring
