#include "exercises/11_exact_contact/1_natural_map.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

/// In the plane of the axis and of the impulse the cone is a wedge, and the nearest point is on one ray or
/// the tip.
Vec3 nearest_point(const Vec3& impulse, double mu)
{
    const Vec3 tangential(0, impulse.y(), impulse.z());
    const double along = tangential.norm();
    if (along <= mu * impulse.x())
        return impulse;
    if (along == 0)  // on the axis, below the tip
        return Vec3::Zero();
    const Vec3 ray = (Vec3::UnitX() + mu * tangential / along).normalized();
    return std::max(0.0, ray.dot(impulse)) * ray;
}

Vec3 map_of_contact(const Vec3& impulse, const Vec3& velocity, double mu)
{
    const double slip = (velocity - velocity.x() * Vec3::UnitX()).norm();
    return impulse - nearest_point(impulse - velocity - mu * slip * Vec3::UnitX(), mu);
}

Vec3 impulse_on_block(const Vec3& free_velocity, double mass, double mu)
{
    if (free_velocity.x() >= 0)
        return Vec3::Zero();
    const Vec3 to_stop = -mass * free_velocity;
    const Vec3 friction(0, to_stop.y(), to_stop.z());
    const double part = friction.norm() > mu * to_stop.x() ? mu * to_stop.x() / friction.norm() : 1;
    return to_stop.x() * Vec3::UnitX() + part * friction;
}

int passes_needed(double h, double part)
{
    const auto passes = static_cast<int>(std::ceil(std::log(1 / part) / std::log1p(h) - 1e-9));
    return std::max(1, passes);
}

}  // namespace enduring
