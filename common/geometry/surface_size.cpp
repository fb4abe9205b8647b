#include "common/geometry/surface_size.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace enduring {
namespace {

double diameter(std::span<const Vec3> positions)
{
    const Vec3 mean = std::accumulate(positions.begin(), positions.end(), Vec3(Vec3::Zero())) /
                      static_cast<double>(positions.size());
    double radius = 0;
    for (const Vec3& x : positions)
        radius = std::max(radius, (x - mean).norm());
    return 2 * radius;
}

}  // namespace

double surface_size(const SurfaceTopology& surface, std::span<const Vec3> positions)
{
    if (surface.faces().empty())
        return positions.empty() ? 0 : diameter(positions);
    double area = 0, volume = 0;
    for (const auto& [i, j, k] : surface.faces()) {
        const Vec3 a = positions[i] - positions[0], b = positions[j] - positions[0],
                   c = positions[k] - positions[0];
        area += (b - a).cross(c - a).norm() / 2;
        volume += a.dot(b.cross(c)) / 6;
    }
    if (surface.is_closed() && volume > 0)
        return 6 * volume / area;
    return std::sqrt(area / 6);
}

}  // namespace enduring
