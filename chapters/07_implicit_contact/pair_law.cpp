#include "chapters/07_implicit_contact/pair_law.hpp"

#include "chapters/07_implicit_contact/weighted_impulse.hpp"

#include <algorithm>

namespace enduring {

Vec3 spring_impulse(const PairLaw& pair, const Vec3& velocity, const StepLaw& step)
{
    const Vec3 stretch = pair.stretch + step.dt * velocity;
    return -pair.stiffness * step.dt * (stretch - pair.normal.dot(stretch) * pair.normal);
}

//! [push]
PairPush pushed(const PairLaw& pair, const Vec3& velocity, const StepLaw& step)
{
    const double depth_t1 = pair.depth_t0 + step.dt * pair.normal.dot(velocity);
    const auto [impulse, slope] = weighted_impulse(pair.depth_t0, depth_t1, step.centre, pair.stiffness,
                                                   step.dt);
    PairPush push{impulse * pair.normal};
    push.slope = slope;
    push.limit = std::max(0.0, pair.mu * pair.lagged_normal_impulse);
    if (push.limit == 0)
        return push;

    // A spring that gives: its end moves with p, its impulse never exceeds the limit.
    push.spring = spring_impulse(pair, velocity, step);
    push.slips = push.spring.squaredNorm() > push.limit * push.limit;
    push.friction = push.slips ? Vec3(push.limit / push.spring.norm() * push.spring) : push.spring;
    return push;
}
//! [push]

double normal_impulse(const PairLaw& pair, const Vec3& velocity, const StepLaw& step)
{
    return weighted_impulse(pair.depth_t0, pair.depth_t0 + step.dt * pair.normal.dot(velocity), step.centre,
                            pair.stiffness, step.dt)
        .impulse;
}

//! [answer]
Mat3 hessian_of(const PairLaw& pair, const PairPush& push, const StepLaw& step)
{
    const Vec3& n = pair.normal;
    const double k = pair.stiffness, dt = step.dt;
    Mat3 hessian = -dt * push.slope * n * n.transpose();
    if (push.limit == 0)
        return hessian;
    const Mat3 along = Mat3::Identity() - n * n.transpose();
    if (!push.slips)
        return hessian + k * dt * dt * along;
    const Vec3 direction = push.friction / push.limit;
    return hessian +
           push.limit / push.spring.norm() * k * dt * dt * (along - direction * direction.transpose());
}
//! [answer]

}  // namespace enduring
