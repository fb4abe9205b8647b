#include "exercises/09_deep_contacts/3_separation_direction.hpp"

namespace enduring {

Vec3 vector_area(const Loop& loop)
{
    Vec3 area = Vec3::Zero();
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
        area += (loop[i] - loop[0]).cross(loop[i + 1] - loop[0]) / 2;
    return area;
}

std::optional<Vec3> separation_direction(const std::vector<Loop>& loops, double cancelled)
{
    Vec3 sum = Vec3::Zero();
    double size = 0;
    for (const Loop& loop : loops) {
        const Vec3 area = vector_area(loop);
        sum += area;
        size += area.norm();
    }
    if (size == 0 || sum.norm() < cancelled * size)
        return std::nullopt;
    return -sum.normalized();
}

Vec3 turning(const Loop& loop, const Vec3& centre)
{
    if (loop.empty())
        return Vec3::Zero();
    // About the first point, where numbers are small; then about the centre.
    const Vec3 origin = loop[0];
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec3 p = loop[i] - origin, q = loop[(i + 1) % loop.size()] - origin;
        const double mean_square = (p.dot(p) + p.dot(q) + q.dot(q)) / 3;
        sum -= mean_square / 2 * (q - p);
    }
    return sum + (origin - centre).cross(vector_area(loop));
}

}  // namespace enduring
