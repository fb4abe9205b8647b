#include "exercises/04_friction/2_grain.hpp"

namespace enduring {

bool holds(const Grain& grain, const Vec2& wanted, double normal_impulse)
{
    const Vec2 across(-grain.direction.y(), grain.direction.x());
    const Vec2 scaled(wanted.dot(grain.direction) / grain.mu_along, wanted.dot(across) / grain.mu_across);
    return scaled.norm() <= normal_impulse;
}

Vec2 sliding_impulse(const Grain& grain, const Vec2& velocity, double normal_impulse)
{
    const Vec2 across(-grain.direction.y(), grain.direction.x());
    const Vec2 scaled(grain.mu_along * velocity.dot(grain.direction), grain.mu_across * velocity.dot(across));
    const double length = scaled.norm();
    if (length == 0)
        return Vec2::Zero();
    // On the ellipse, where its outward normal is against the velocity.
    const Vec2 share = scaled / length;
    return -normal_impulse *
           (grain.mu_along * share.x() * grain.direction + grain.mu_across * share.y() * across);
}

Vec2 stopping_place(const Grain& grain, Vec2 velocity, double gravity, double dt)
{
    Vec2 place = Vec2::Zero();
    while (velocity.norm() > 0) {
        const Vec2 next = velocity + sliding_impulse(grain, velocity, gravity * dt);  // of a mass of 1 kg
        if (next.dot(velocity) <= 0)
            return place;
        velocity = next;
        place += dt * velocity;
    }
    return place;
}

}  // namespace enduring
