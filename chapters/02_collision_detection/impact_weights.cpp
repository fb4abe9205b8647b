#include "chapters/02_collision_detection/impact_weights.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

/// Weight of b at the point of the segment a-b closest to p.
double weight_on_segment(const Vec3& p, const Vec3& a, const Vec3& b)
{
    const Vec3 along = b - a;
    const double length_squared = along.squaredNorm();
    return length_squared > 0 ? std::clamp((p - a).dot(along) / length_squared, 0.0, 1.0) : 0.0;
}

/// Keeps the candidate with the smallest distance; a distance that is not a number never wins.
template <std::size_t Count>
struct Closest {
    std::array<double, Count> weights{};
    double distance = INFINITY;

    void offer(const std::array<double, Count>& candidate, double candidate_distance)
    {
        if (candidate_distance < distance) {
            weights = candidate;
            distance = candidate_distance;
        }
    }
};

/// A size to divide by, so that squares of very small or large coordinates stay numbers.
double size_of(std::initializer_list<Vec3> differences)
{
    double size = 0;
    for (const Vec3& d : differences)
        size = std::max(size, d.cwiseAbs().maxCoeff());
    return size > 0 ? size : 1;
}

}  // namespace

std::array<double, 3> impact_weights(const VertexFaceStep& step, double tau)
{
    // Seen from the vertex, which becomes the origin. Differences first:
    // far from the origin only they are precise.
    std::array<Vec3, 3> f{at_time(step.f0_t0 - step.v_t0, step.f0_t1 - step.v_t1, tau),
                          at_time(step.f1_t0 - step.v_t0, step.f1_t1 - step.v_t1, tau),
                          at_time(step.f2_t0 - step.v_t0, step.f2_t1 - step.v_t1, tau)};
    const double size = size_of({f[0], f[1], f[2]});
    for (Vec3& corner : f)
        corner /= size;

    const Vec3 normal = (f[1] - f[0]).cross(f[2] - f[0]);
    const Vec3 inside(f[1].cross(f[2]).dot(normal), f[2].cross(f[0]).dot(normal),
                      f[0].cross(f[1]).dot(normal));
    Closest<3> closest;
    if (inside.minCoeff() >= 0 && inside.sum() > 0) {
        const Vec3 w = inside / inside.sum();
        closest.offer({w[0], w[1], w[2]}, (w[0] * f[0] + w[1] * f[1] + w[2] * f[2]).norm());
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const double w = weight_on_segment(Vec3::Zero(), f[i], f[j]);
        std::array<double, 3> weights{};
        weights[i] = 1 - w;
        weights[j] = w;
        closest.offer(weights, ((1 - w) * f[i] + w * f[j]).norm());
    }
    return closest.weights;
}

std::array<double, 2> impact_weights(const EdgeEdgeStep& step, double tau)
{
    const auto seen_from_ea0 = [&](const Vec3& x_t0, const Vec3& x_t1) -> Vec3 {
        return at_time(x_t0 - step.ea0_t0, x_t1 - step.ea0_t1, tau);
    };
    Vec3 a1 = seen_from_ea0(step.ea1_t0, step.ea1_t1), b0 = seen_from_ea0(step.eb0_t0, step.eb0_t1),
         b1 = seen_from_ea0(step.eb1_t0, step.eb1_t1);
    const double size = size_of({a1, b0, b1});
    a1 /= size, b0 /= size, b1 /= size;
    const Vec3 a0 = Vec3::Zero(), b = b1 - b0;

    Closest<2> closest;
    const auto offer = [&](double s, double t) { closest.offer({s, t}, (s * a1 - (b0 + t * b)).norm()); };
    const Vec3 normal = a1.cross(b);
    const double s = b0.cross(b).dot(normal) / normal.squaredNorm(),
                 t = b0.cross(a1).dot(normal) / normal.squaredNorm();
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1)
        offer(s, t);
    offer(0, weight_on_segment(a0, b0, b1));
    offer(1, weight_on_segment(a1, b0, b1));
    offer(weight_on_segment(b0, a0, a1), 0);
    offer(weight_on_segment(b1, a0, a1), 1);
    return closest.weights;
}

}  // namespace enduring
