#include "exercises/11_exact_contact/1_natural_map.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

Vec3 nearest_point(const Vec3& impulse, double mu)
{
    const double normal = impulse.x(), along = std::hypot(impulse.y(), impulse.z());
    if (along <= mu * normal)
        return impulse;
    if (mu * along <= -normal)
        return Vec3::Zero();
    const double height = (normal + mu * along) / (1 + mu * mu);
    return {height, mu * height * impulse.y() / along, mu * height * impulse.z() / along};
}

Vec3 map_of_contact(const Vec3& impulse, const Vec3& velocity, double mu)
{
    Vec3 lifted = velocity;
    lifted.x() += mu * std::hypot(velocity.y(), velocity.z());
    return impulse - nearest_point(impulse - lifted, mu);
}

Vec3 impulse_on_block(const Vec3& free_velocity, double mass, double mu)
{
    const double normal = std::max(0.0, -mass * free_velocity.x());
    Vec3 impulse(normal, -mass * free_velocity.y(), -mass * free_velocity.z());
    const double wanted = std::hypot(impulse.y(), impulse.z());
    if (wanted > mu * normal)
        impulse.tail<2>() *= mu * normal / wanted;
    return impulse;
}

int passes_needed(double h, double part)
{
    int passes = 0;
    for (double left = 1; left > part; left /= 1 + h)
        ++passes;
    return passes;
}

}  // namespace enduring
