#include "exercises/11_exact_contact/3_relaxed_lift.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

Vec3 relaxed_impulse(const Vec3& free_velocity, double mass, double mu)
{
    const Vec3 wanted = -mass * free_velocity;
    const double along = std::hypot(wanted.y(), wanted.z());
    if (along <= mu * wanted.x())
        return wanted;
    if (mu * along <= -wanted.x())
        return Vec3::Zero();
    const double normal = (wanted.x() + mu * along) / (1 + mu * mu);
    return {normal, mu * normal * wanted.y() / along, mu * normal * wanted.z() / along};
}

double rising_speed(const Vec3& free_velocity, double mass, double mu)
{
    return free_velocity.x() + relaxed_impulse(free_velocity, mass, mu).x() / mass;
}

double gap_after(const BlockOverGround& block, double mu, double dt)
{
    const Vec3 free_velocity(block.gap / dt + block.rising - 9.81 * dt, block.speed, 0);
    return dt * rising_speed(free_velocity, 1, mu);
}

double floating_gap(double speed, double mu, double dt)
{
    return mu * speed * dt;
}

}  // namespace enduring
