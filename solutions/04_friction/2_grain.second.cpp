// A second way: no formula for the point of the ellipse. Of many directions,
// the one that takes the most energy is searched.
#include "exercises/04_friction/2_grain.hpp"

#include <cmath>
#include <numbers>

namespace enduring {

static Vec2 on_the_ellipse(const Grain& grain, double angle)
{
    const Vec2 across(-grain.direction.y(), grain.direction.x());
    return grain.mu_along * std::cos(angle) * grain.direction + grain.mu_across * std::sin(angle) * across;
}

bool holds(const Grain& grain, const Vec2& wanted, double normal_impulse)
{
    Mat2 axes;
    axes << on_the_ellipse(grain, 0), on_the_ellipse(grain, 0.5 * std::numbers::pi);
    return axes.inverse().operator*(wanted).squaredNorm() <= normal_impulse * normal_impulse;
}

Vec2 sliding_impulse(const Grain& grain, const Vec2& velocity, double normal_impulse)
{
    if (velocity.isZero(0))
        return Vec2::Zero();
    double low = 0, high = 0, best = 1e300;
    for (int i = 0; i < 64; ++i) {
        const double angle = i * std::numbers::pi / 32;
        if (const double work = on_the_ellipse(grain, angle).dot(velocity); work < best) {
            best = work;
            low = angle - 0.1;
            high = angle + 0.1;
        }
    }
    while (high - low > 1e-9) {
        const double left = low + (high - low) / 3, right = high - (high - low) / 3;
        const bool left_is_better = on_the_ellipse(grain, left).dot(velocity) <
                                    on_the_ellipse(grain, right).dot(velocity);
        (left_is_better ? high : low) = left_is_better ? right : left;
    }
    return normal_impulse * on_the_ellipse(grain, 0.5 * (low + high));
}

Vec2 stopping_place(const Grain& grain, Vec2 velocity, double gravity, double dt)
{
    Vec2 place = Vec2::Zero();
    for (;;) {
        const Vec2 next = velocity + sliding_impulse(grain, velocity, gravity * dt);
        if (next.dot(velocity) <= 0)
            return place;
        place += dt * next;
        velocity = next;
    }
}

}  // namespace enduring
