#include "chapters/motivating_scenes/self_crossings.hpp"

#include "common/geometry/offset_surface.hpp"

#include <Eigen/Geometry>

namespace enduring::motivating {
namespace {

/// By the signs of volumes. They say nothing of what lies in one plane, far apart; so the boxes around both
/// have to meet.
bool passes_through(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const auto box = [](const Vec3& first, const auto&... others) {
        Eigen::AlignedBox3d all(first);
        (all.extend(others), ...);
        return all;
    };
    if (!box(p, q).intersects(box(a, b, c)))
        return false;
    const auto above = [](const Vec3& u, const Vec3& v, const Vec3& w, const Vec3& x) {
        return (v - u).cross(w - u).dot(x - u) > 0;
    };
    const bool side = above(p, q, a, b);
    return above(a, b, c, p) != above(a, b, c, q) && side == above(p, q, b, c) && side == above(p, q, c, a);
}

}  // namespace

int self_crossings(const Body& body, std::span<const Vec3> first, double apart, double skin)
{
    const std::vector<Vec3> x = offset_surface(body.surface().faces(), body.positions_t0(), -skin);
    int crossings = 0;
    for (const auto& [p, q] : body.surface().edges())
        for (const auto& [a, b, c] : body.surface().faces()) {
            const Vec3 edge = (first[p] + first[q]) / 2, face = (first[a] + first[b] + first[c]) / 3;
            crossings += (edge - face).norm() > apart && passes_through(x[p], x[q], x[a], x[b], x[c]);
        }
    return crossings;
}

}  // namespace enduring::motivating
