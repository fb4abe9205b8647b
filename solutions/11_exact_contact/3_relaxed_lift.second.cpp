#include "exercises/11_exact_contact/3_relaxed_lift.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

/// What the energy asks for is the impulse that stops the block; in the plane of the normal and of the slip
/// it is nearest to a ray.
Vec3 relaxed_impulse(const Vec3& free_velocity, double mass, double mu)
{
    const Vec3 slip(0, free_velocity.y(), free_velocity.z());
    if (slip.norm() <= -mu * free_velocity.x())
        return -mass * free_velocity;
    const Vec3 direction = slip.norm() > 0 ? Vec3(slip / slip.norm()) : Vec3(Vec3::Zero());
    const Vec3 ray = Vec3::UnitX() - mu * direction;
    return std::max(0.0, -mass * free_velocity.dot(ray) / ray.squaredNorm()) * ray;
}

/// By cases: it holds, flies, or rises with mu times what is left of its slip.
double rising_speed(const Vec3& free_velocity, double mass, double mu)
{
    const Vec3 after = free_velocity + relaxed_impulse(free_velocity, mass, mu) / mass;
    return std::max(free_velocity.x(), mu * std::hypot(after.y(), after.z()));
}

double gap_after(const BlockOverGround& block, double mu, double dt)
{
    const double untouched = block.gap + block.rising * dt - 9.81 * dt * dt;
    const double slip = std::abs(block.speed) * dt;
    if (untouched >= mu * slip)
        return untouched;
    return std::max(0.0, mu * (slip + mu * untouched) / (1 + mu * mu));
}

double floating_gap(double speed, double mu, double dt) { return dt * mu * speed; }

}  // namespace enduring
