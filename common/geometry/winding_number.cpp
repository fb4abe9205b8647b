#include "common/geometry/winding_number.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace enduring {
namespace {

/// Of a triangle as seen from the origin, positive where its outer side looks away.
double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c)
{
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    return 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

}  // namespace

double winding_number(std::span<const Face> faces, std::span<const Vec3> positions, const Vec3& point)
{
    const auto seen = [&](int vertex) -> Vec3 { return positions[vertex] - point; };
    double sum = 0;
    for (const auto& [i, j, k] : faces)
        sum += solid_angle(seen(i), seen(j), seen(k));
    return sum / (4 * std::numbers::pi);
}

}  // namespace enduring
