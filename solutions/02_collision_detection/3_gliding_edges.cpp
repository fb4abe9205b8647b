#include "exercises/02_collision_detection/3_gliding_edges.hpp"

#include <algorithm>

namespace enduring {

Times when_between(const Times& times, double at_start, double rate, double low, double high)
{
    if (rate == 0)
        return low <= at_start && at_start <= high ? times : Times{1, 0};
    const double at_low = (low - at_start) / rate, at_high = (high - at_start) / rate;
    return {std::max(times.first, std::min(at_low, at_high)),
            std::min(times.last, std::max(at_low, at_high))};
}

std::optional<double> first_touch_of_gliding_edge(const Vec3& a0, const Vec3& a1, const Vec3& way,
                                                  const Vec3& b0, const Vec3& b1)
{
    const Vec3 u = a1 - a0, w = b1 - b0, apart = b0 - a0, normal = u.cross(w);
    Times times;
    if (normal.squaredNorm() > 0) {
        const double whole = normal.squaredNorm();
        times = when_between(times, apart.dot(normal), -way.dot(normal), 0, 0);
        times = when_between(times, apart.cross(w).dot(normal), -way.cross(w).dot(normal), 0, whole);
        times = when_between(times, apart.cross(u).dot(normal), -way.cross(u).dot(normal), 0, whole);
    } else {
        // Parallel: apart is a multiple of u, between those that ends opposite each other have.
        const Vec3 beside = apart.cross(u), beside_rate = -way.cross(u);
        for (int axis = 0; axis < 3; ++axis)
            times = when_between(times, beside[axis], beside_rate[axis], 0, 0);
        const double reach = -w.dot(u), whole = u.squaredNorm();
        times = when_between(times, apart.dot(u), -way.dot(u), std::min(0.0, reach),
                             whole + std::max(0.0, reach));
    }
    return times.empty() ? std::nullopt : std::optional(times.first);
}

}  // namespace enduring
