#include "exercises/08_contact_by_distance/91_cone.hpp"

#include <algorithm>

namespace enduring {

bool in_cone(const Vec3& x, const std::vector<Vec3>& neighbours, const Vec3& d, double sine)
{
    for (const Vec3& y : neighbours)
        if (d.dot(y - x) > sine * (y - x).norm())
            return false;
    return true;
}

bool in_cone_of_edge(const Vec3& a, const Vec3& b, const Vec3& left, const Vec3& right, const Vec3& d,
                     double sine)
{
    const Vec3 along = (b - a).normalized();
    if (!in_cone(a, {b}, d, sine) || !in_cone(b, {a}, d, sine))
        return false;
    std::vector<Vec3> beside;
    for (const Vec3& corner : {left, right})
        beside.push_back(corner - along.dot(corner - a) * along);
    return in_cone(a, beside, d, sine);
}

std::vector<Push> one_of_each_line(std::vector<Push> pushes, double apart)
{
    std::sort(pushes.begin(), pushes.end(),
              [](const Push& one, const Push& other) { return one.key < other.key; });
    std::vector<Push> kept;
    for (const Push& push : pushes) {
        const bool known = std::any_of(kept.begin(), kept.end(), [&](const Push& first) {
            const bool parallel = first.normal.cross(push.normal).norm() <= 1e-6;
            return parallel && first.normal.cross(push.point - first.point).norm() <= apart;
        });
        if (!known)
            kept.push_back(push);
    }
    return kept;
}

}  // namespace enduring
