#include "exercises/09_deep_contacts/3_separation_direction.hpp"

namespace enduring {
namespace {

// The integrals depend on the border alone, so any surface with this border will do: a fan of triangles
// around the mean of the points.
template <class Visit>
void visit_fan(const Loop& loop, Visit&& visit)
{
    if (loop.size() < 3)
        return;
    Vec3 apex = Vec3::Zero();
    for (const Vec3& point : loop)
        apex += (point - loop[0]) / static_cast<double>(loop.size());
    apex += loop[0];
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec3 &p = loop[i], &q = loop[i + 1 == loop.size() ? 0 : i + 1];
        visit(Vec3((p - apex).cross(q - apex) / 2), Vec3(apex + (p - apex) / 3 + (q - apex) / 3));
    }
}

}  // namespace

Vec3 vector_area(const Loop& loop)
{
    Vec3 sum = Vec3::Zero();
    visit_fan(loop, [&](const Vec3& area, const Vec3&) { sum += area; });
    return sum;
}

std::optional<Vec3> separation_direction(const std::vector<Loop>& loops, double cancelled)
{
    std::vector<Vec3> areas;
    Vec3 sum = Vec3::Zero();
    double size = 0;
    for (const Loop& loop : loops)
        areas.push_back(vector_area(loop));
    for (const Vec3& area : areas) {
        sum -= area;
        size += area.norm();
    }
    return size > 0 && sum.norm() >= cancelled * size ? std::optional<Vec3>(sum / sum.norm()) : std::nullopt;
}

Vec3 turning(const Loop& loop, const Vec3& centre)
{
    Vec3 sum = Vec3::Zero();
    visit_fan(loop, [&](const Vec3& area, const Vec3& middle) { sum += (middle - centre).cross(area); });
    return sum;
}

}  // namespace enduring
