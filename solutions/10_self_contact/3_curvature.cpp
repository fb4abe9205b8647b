#include "exercises/10_self_contact/3_curvature.hpp"

#include <algorithm>

namespace enduring {

std::optional<Vec3> common_side(const std::vector<Vec3>& normals)
{
    Vec3 direction = Vec3::Zero();
    for (int round = 0; round < 1000; ++round) {
        const auto farther = [&](const Vec3& a, const Vec3& b) {
            return a.dot(direction) < b.dot(direction);
        };
        const Vec3& worst = *std::min_element(normals.begin(), normals.end(), farther);
        if (worst.dot(direction) > 1e-9 * direction.norm())
            return direction.normalized();
        direction += worst;
    }
    return std::nullopt;
}

bool border_crosses_itself(const std::vector<Vec3>& border, const Vec3& direction)
{
    const std::size_t count = border.size();
    const auto corner = [&](std::size_t i) -> const Vec3& { return border[i % count]; };
    const auto left = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        return direction.dot((b - a).cross(c - a)) > 0;
    };
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 2; j < count; ++j) {
            if (i == 0 && j == count - 1)
                continue;  // they share the first corner
            const Vec3 &a = corner(i), &b = corner(i + 1), &c = corner(j), &d = corner(j + 1);
            if (left(a, b, c) != left(a, b, d) && left(c, d, a) != left(c, d, b))
                return true;
        }
    return false;
}

bool may_touch_itself(const std::vector<Vec3>& normals, const std::vector<Vec3>& border)
{
    const std::optional<Vec3> side = common_side(normals);
    return !side || border_crosses_itself(border, *side);
}

}  // namespace enduring
