// A second way to the distance: minimise over the two barycentric weights by projecting the
// point onto the triangle's plane, clipping along its sides one after the other (Ericson's
// regions), and a bound without the corner that stands still.
#include "exercises/02_collision_detection/2_conservative_time.hpp"

#include <algorithm>

namespace enduring {

static Vec3 closest_point(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 ab = b - a, ac = c - a;
    const double d1 = ab.dot(p - a), d2 = ac.dot(p - a), d3 = ab.dot(p - b), d4 = ac.dot(p - b),
                 d5 = ab.dot(p - c), d6 = ac.dot(p - c);
    if (d1 <= 0 && d2 <= 0)
        return a;
    if (d3 >= 0 && d4 <= d3)
        return b;
    if (d6 >= 0 && d5 <= d6)
        return c;
    const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
    if (vc <= 0 && d1 >= 0 && d3 <= 0 && d1 > d3)
        return a + d1 / (d1 - d3) * ab;
    if (vb <= 0 && d2 >= 0 && d6 <= 0)
        return a + d2 / (d2 - d6) * ac;
    if (va <= 0 && d4 >= d3 && d5 >= d6)
        return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
    return a + vb / (va + vb + vc) * ab + vc / (va + vb + vc) * ac;
}

double distance_to_triangle(const Vec3& point, const Vec3& f0, const Vec3& f1, const Vec3& f2)
{
    return (point - closest_point(point, f0, f1, f2)).norm();
}

double fastest_approach(const VertexFaceStep& step)
{
    double fastest = 0;
    const Vec3 way = step.v_t1 - step.v_t0;
    for (const Vec3& corner :
         {Vec3(step.f0_t1 - step.f0_t0), Vec3(step.f1_t1 - step.f1_t0), Vec3(step.f2_t1 - step.f2_t0)})
        fastest = std::max(fastest, corner.norm() + way.norm());
    return fastest;
}

std::optional<double> conservative_time(const VertexFaceStep& step, double gap, double close)
{
    const auto distance_at = [&](double tau) {
        return distance_to_triangle(at_time(step.v_t0, step.v_t1, tau), at_time(step.f0_t0, step.f0_t1, tau),
                                    at_time(step.f1_t0, step.f1_t1, tau),
                                    at_time(step.f2_t0, step.f2_t1, tau));
    };
    for (double tau = 0; tau < 1;) {
        const double room = distance_at(tau) - gap;
        if (room <= close)
            return tau;
        const double next = tau + room / fastest_approach(step);
        if (!(next < 1))
            return std::nullopt;
        tau = next;
    }
    return std::nullopt;
}

}  // namespace enduring
