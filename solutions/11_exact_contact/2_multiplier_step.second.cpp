#include "exercises/11_exact_contact/2_multiplier_step.hpp"

#include <cmath>

namespace enduring {
namespace {

double h_of(const BlockOnSpring& block) { return block.stiffness * block.dt * block.dt / block.mass; }

}  // namespace

/// The velocity first: m (u - q) = k dt (begin - dt u), and the impulse from what it changes.
Vec3 impulse_of_spring(const BlockOnSpring& block, const Vec3& begin)
{
    const double h = h_of(block);
    const Vec3 velocity = (block.free_velocity + h / block.dt * begin) / (1 + h);
    const Vec3 impulse = block.mass * (velocity - block.free_velocity);
    if (impulse.x() <= 0)
        return Vec3::Zero();
    const Vec3 friction(0, impulse.y(), impulse.z());
    const double limit = block.mu * impulse.x();
    return impulse.x() * Vec3::UnitX() + (friction.norm() > limit ? limit * friction.normalized() : friction);
}

Vec3 next_begin(const BlockOnSpring& block, const Vec3& impulse)
{
    return block.dt / (h_of(block) * block.mass) * impulse;
}

Vec3 impulse_after(const BlockOnSpring& block, int passes)
{
    if (passes == 0)
        return Vec3::Zero();
    return impulse_of_spring(block, next_begin(block, impulse_after(block, passes - 1)));
}

/// What each pass adds is 1 / (1 + h) of what the one before added.
Vec3 predicted_impulse(const BlockOnSpring& block, const Vec3& exact, int passes)
{
    const double h = h_of(block);
    double sum = 0, added = h / (1 + h);
    for (int pass = 0; pass < passes; ++pass, added /= 1 + h)
        sum += added;
    return sum * exact;
}

}  // namespace enduring
