#include "exercises/05_categorisation/3_share_of_directions.hpp"

#include <cmath>
#include <numbers>

namespace enduring::chapter05 {

double predicted_share() { return 0.125; }

std::vector<Vec3> even_directions(int count)
{
    const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
    std::vector<Vec3> directions;
    for (int i = 0; i < count; ++i) {
        const double y = 1 - (2 * i + 1.0) / count;
        const double radius = std::sqrt(1 - y * y);
        directions.emplace_back(radius * std::cos(i * golden_angle), y, radius * std::sin(i * golden_angle));
    }
    return directions;
}

double measured_share(const Corner& corner, int count)
{
    int touching = 0;
    for (const Vec3& direction : even_directions(count))
        if (can_touch(corner, direction))
            ++touching;
    return static_cast<double>(touching) / count;
}

double law_of_share(const std::array<Vec3, 3>& normals)
{
    const auto& [a, b, c] = normals;
    const double volume = std::abs(a.dot(b.cross(c)));
    const double solid_angle = 2 * std::atan2(volume, 1 + a.dot(b) + b.dot(c) + c.dot(a));
    return solid_angle / (4 * std::numbers::pi);
}

}  // namespace enduring::chapter05
