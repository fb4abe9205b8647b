#include "chapters/07_implicit_contact/pair_law.hpp"

#include "chapters/07_implicit_contact/weighted_impulse.hpp"

#include <algorithm>

namespace enduring {

Vec3 spring_impulse(const PairLaw& pair, const Vec3& velocity, const StepLaw& step)
{
    const Vec3 stretch = pair.stretch + step.dt * velocity;
    return -pair.stiffness * step.dt * (stretch - pair.normal.dot(stretch) * pair.normal);
}

namespace {

/// What a pair pushes, and what the derivative needs besides.
struct PushAndSlope {
    PairPush push;
    double slope = 0;  ///< of the normal impulse over the depth at the end [N s/m]
    /// of friction, and what its spring would push if it never gave, where there is a limit [N s]
    double limit = 0, wanted = 0;
};

//! [push]
PushAndSlope push_and_slope(const PairLaw& pair, const Vec3& velocity, const StepLaw& step)
{
    const double depth_t1 = pair.depth_t0 + step.dt * pair.normal.dot(velocity);
    const auto [impulse, slope] = weighted_impulse(pair.depth_t0, depth_t1, step.centre, pair.stiffness,
                                                   step.dt);
    PushAndSlope result{{impulse * pair.normal, Vec3::Zero()}, slope};
    result.limit = std::max(0.0, pair.mu * pair.lagged_normal_impulse);
    if (result.limit == 0)
        return result;

    // A spring that gives: its end moves with p, its impulse never exceeds the limit.
    const Vec3 wanted = spring_impulse(pair, velocity, step);
    result.wanted = wanted.norm();
    result.push.slips = result.wanted > result.limit;
    result.push.friction = result.push.slips ? Vec3(result.limit / result.wanted * wanted) : wanted;
    return result;
}
//! [push]

}  // namespace

double normal_impulse(const PairLaw& pair, const Vec3& velocity, const StepLaw& step)
{
    return weighted_impulse(pair.depth_t0, pair.depth_t0 + step.dt * pair.normal.dot(velocity), step.centre,
                            pair.stiffness, step.dt)
        .impulse;
}

PairPush pushed(const PairLaw& pair, const Vec3& velocity, const StepLaw& step)
{
    return push_and_slope(pair, velocity, step).push;
}

//! [answer]
PairAnswer answer(const PairLaw& pair, const Vec3& velocity, const StepLaw& step)
{
    const Vec3& n = pair.normal;
    const double k = pair.stiffness, dt = step.dt;
    const auto [push, slope, limit, wanted] = push_and_slope(pair, velocity, step);
    PairAnswer result{push, -dt * slope * n * n.transpose()};
    if (limit == 0)
        return result;
    const Mat3 along = Mat3::Identity() - n * n.transpose();
    if (!push.slips) {
        result.hessian += k * dt * dt * along;
        return result;
    }
    const Vec3 direction = push.friction / limit;
    result.hessian += limit / wanted * k * dt * dt * (along - direction * direction.transpose());
    return result;
}
//! [answer]

}  // namespace enduring
