#include "exercises/02_collision_detection/2_conservative_time.hpp"

#include <algorithm>

namespace enduring {

static double distance_to_segment(const Vec3& point, const Vec3& a, const Vec3& b)
{
    const Vec3 along = b - a;
    const double squared_length = along.squaredNorm();
    const double place = squared_length > 0 ? std::clamp((point - a).dot(along) / squared_length, 0.0, 1.0)
                                            : 0.0;
    return (point - a - place * along).norm();
}

double distance_to_triangle(const Vec3& point, const Vec3& f0, const Vec3& f1, const Vec3& f2)
{
    const Vec3 side_1 = f1 - f0, side_2 = f2 - f0, normal = side_1.cross(side_2), offset = point - f0;
    const double squared_length = normal.squaredNorm();
    const double w1 = offset.cross(side_2).dot(normal), w2 = side_1.cross(offset).dot(normal);
    if (squared_length > 0 && w1 >= 0 && w2 >= 0 && w1 + w2 <= squared_length)
        return std::abs(offset.dot(normal)) / std::sqrt(squared_length);
    return std::min({distance_to_segment(point, f0, f1), distance_to_segment(point, f1, f2),
                     distance_to_segment(point, f2, f0)});
}

double fastest_approach(const VertexFaceStep& step)
{
    const double corner = std::max({(step.f0_t1 - step.f0_t0).norm(), (step.f1_t1 - step.f1_t0).norm(),
                                    (step.f2_t1 - step.f2_t0).norm()});
    return (step.v_t1 - step.v_t0).norm() + corner;
}

std::optional<double> conservative_time(const VertexFaceStep& step, double gap, double close)
{
    const double fastest = fastest_approach(step);
    double tau = 0;
    while (tau < 1) {
        const double distance = distance_to_triangle(
            at_time(step.v_t0, step.v_t1, tau), at_time(step.f0_t0, step.f0_t1, tau),
            at_time(step.f1_t0, step.f1_t1, tau), at_time(step.f2_t0, step.f2_t1, tau));
        if (distance <= gap + close)
            return tau;
        if (fastest == 0)
            return std::nullopt;
        tau += (distance - gap) / fastest;  // so long nothing can come nearer than the gap
    }
    return std::nullopt;
}

}  // namespace enduring
