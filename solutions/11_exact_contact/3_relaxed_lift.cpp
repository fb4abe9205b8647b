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
    const double side = mu * normal / along;
    return {normal, side * wanted.y(), side * wanted.z()};
}

double rising_speed(const Vec3& free_velocity, double mass, double mu)
{
    const Vec3 impulse = relaxed_impulse(free_velocity, mass, mu);
    return free_velocity.x() + impulse.x() / mass;
}

double gap_after(const BlockOverGround& block, double mu, double dt)
{
    const double opening = block.gap / dt + block.rising - 9.81 * dt;
    const Vec3 free_velocity(opening, block.speed, 0);
    return dt * rising_speed(free_velocity, 1, mu);
}

double floating_gap(double speed, double mu, double dt) { return mu * speed * dt; }

}  // namespace enduring
