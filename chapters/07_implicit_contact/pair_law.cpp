#include "chapters/07_implicit_contact/pair_law.hpp"

#include "chapters/07_implicit_contact/grain_friction.hpp"
#include "chapters/07_implicit_contact/viscous_friction.hpp"
#include "chapters/07_implicit_contact/weighted_impulse.hpp"

#include <algorithm>

namespace enduring {

Vec3 spring_impulse(const PairLaw& pair, const Vec3& velocity, const StepLaw& step)
{
    const Vec3 stretch = pair.has_grain ? stretch_on_grain(pair.grain, pair.stretch, step.dt * velocity)
                                        : Vec3(pair.stretch + step.dt * velocity);
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
    if (pair.viscous > 0)
        push.friction = film_impulse(pair, velocity);
    if (push.limit == 0)
        return push;

    // A spring that gives: its end moves with p, its impulse never exceeds the limit.
    push.spring = spring_impulse(pair, velocity, step);
    push.slips = push.spring.squaredNorm() > push.limit * push.limit;
    const Vec3 held = push.slips ? Vec3(push.limit / push.spring.norm() * push.spring) : push.spring;
    push.friction += pair.has_grain ? Vec3(pair.grain.transpose() * held) : held;
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
    if (pair.viscous > 0)
        hessian += film_hessian(pair);
    if (push.limit == 0)
        return hessian;
    Mat3 along = k * dt * dt * (Mat3::Identity() - n * n.transpose());
    if (push.slips) {
        const Vec3 direction = push.spring.normalized();
        along = push.limit / push.spring.norm() * (along - k * dt * dt * direction * direction.transpose());
    }
    return hessian + (pair.has_grain ? Mat3(pair.grain.transpose() * along * pair.grain) : along);
}
//! [answer]

}  // namespace enduring
