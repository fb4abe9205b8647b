#include "common/geometry/closest_points.hpp"

#include <algorithm>
#include <limits>

namespace enduring {
namespace {

/// Weight of b at the point of the segment a-b that is nearest to p.
double nearest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b)
{
    const double along = (p - a).dot(b - a), length_squared = (b - a).squaredNorm();
    return length_squared > 0 ? std::clamp(along / length_squared, 0.0, 1.0) : 0;
}

}  // namespace

ClosestOnTriangle closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const std::array<Vec3, 3> x{a, b, c};
    const auto at = [&](const std::array<double, 3>& w) {
        const Vec3 q = w[0] * a + w[1] * b + w[2] * c;
        return ClosestOnTriangle{w, q, (p - q).norm()};
    };
    const Vec3 normal = (b - a).cross(c - a);
    const double area_squared = normal.squaredNorm();
    if (area_squared > 0) {
        const double w0 = (c - b).cross(p - b).dot(normal) / area_squared,
                     w1 = (a - c).cross(p - c).dot(normal) / area_squared, w2 = 1 - w0 - w1;
        if (w0 > 0 && w1 > 0 && w2 > 0)
            return at({w0, w1, w2});
    }
    ClosestOnTriangle best{{}, {}, std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const double w = nearest_on_segment(p, x[i], x[j]);
        std::array<double, 3> weights{};
        weights[i] = 1 - w;
        weights[j] = w;
        if (const ClosestOnTriangle candidate = at(weights); candidate.distance < best.distance)
            best = candidate;
    }
    return best;
}

std::optional<ClosestOnEdges> closest_inside_edges(const Vec3& a0, const Vec3& a1, const Vec3& b0,
                                                   const Vec3& b1, double least_sine)
{
    const Vec3 u = a1 - a0, v = b1 - b0, w = a0 - b0, normal = u.cross(v);
    const double area_squared = normal.squaredNorm();
    if (!(area_squared > least_sine * least_sine * u.squaredNorm() * v.squaredNorm()))
        return std::nullopt;
    const double s = normal.dot(v.cross(w)) / area_squared, t = normal.dot(u.cross(w)) / area_squared;
    if (!(s > 0 && s < 1 && t > 0 && t < 1))
        return std::nullopt;
    return ClosestOnEdges{s, t, w + s * u - t * v};
}

}  // namespace enduring
