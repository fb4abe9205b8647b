#include "chapters/07_implicit_contact/pair_law.hpp"

#include "chapters/07_implicit_contact/weighted_impulse.hpp"

namespace enduring {

Vec3 spring_impulse(const PairLaw& pair, const Vec3& velocity, const StepLaw& step)
{
    const Vec3 stretch = pair.stretch + step.dt * velocity;
    return -pair.stiffness * step.dt * (stretch - pair.normal.dot(stretch) * pair.normal);
}

//! [answer]
PairAnswer answer(const PairLaw& pair, const Vec3& velocity, const StepLaw& step)
{
    const Vec3& n = pair.normal;
    const double k = pair.stiffness, dt = step.dt;
    const auto [impulse, slope] = weighted_impulse(pair.depth_t0, pair.depth_t0 + dt * n.dot(velocity),
                                                   step.centre, k, dt);
    PairAnswer result{impulse * n, Vec3::Zero(), -dt * slope * n * n.transpose()};
    const bool coupled = step.limit == FrictionLimit::coupled;
    const double limit = pair.mu * (coupled ? impulse : pair.pressing);
    if (limit <= 0)
        return result;

    // A spring that gives: its end moves with p, its impulse never exceeds the limit.
    const Mat3 along = Mat3::Identity() - n * n.transpose();
    const Vec3 wanted = spring_impulse(pair, velocity, step);
    const double size = wanted.norm();
    result.slips = size > limit;
    if (!result.slips) {
        result.friction = wanted;
        result.stiffening += k * dt * dt * along;
        return result;
    }
    const Vec3 direction = wanted / size;
    result.friction = limit * direction;
    result.stiffening += limit / size * k * dt * dt * (along - direction * direction.transpose());
    if (coupled)
        result.stiffening -= pair.mu * dt * slope * direction * n.transpose();
    return result;
}
//! [answer]

}  // namespace enduring
