#include "common/geometry/surface_size.hpp"

#include <Eigen/Geometry>

#include <cmath>

namespace enduring {

double surface_size(const SurfaceTopology& surface, std::span<const Vec3> positions)
{
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
