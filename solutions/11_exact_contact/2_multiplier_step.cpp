#include "exercises/11_exact_contact/2_multiplier_step.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

Vec3 impulse_of_spring(const BlockOnSpring& block, const Vec3& begin)
{
    const double push = block.stiffness * block.dt;
    const double h = push * block.dt / block.mass;
    Vec3 impulse = push * (begin - block.dt * block.free_velocity) / (1 + h);
    impulse.x() = std::max(0.0, impulse.x());
    const double wanted = std::hypot(impulse.y(), impulse.z());
    const double limit = block.mu * impulse.x();
    if (wanted > limit)
        impulse.tail<2>() *= limit / wanted;
    return impulse;
}

Vec3 next_begin(const BlockOnSpring& block, const Vec3& impulse)
{
    return impulse / (block.stiffness * block.dt);
}

Vec3 impulse_after(const BlockOnSpring& block, int passes)
{
    Vec3 impulse = Vec3::Zero();
    for (int pass = 0; pass < passes; ++pass) {
        const Vec3 begin = next_begin(block, impulse);
        impulse = impulse_of_spring(block, begin);
    }
    return impulse;
}

Vec3 predicted_impulse(const BlockOnSpring& block, const Vec3& exact, int passes)
{
    const double h = block.stiffness * block.dt * block.dt / block.mass;
    return (1 - std::pow(1 + h, -passes)) * exact;
}

}  // namespace enduring
