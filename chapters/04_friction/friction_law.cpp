#include "chapters/04_friction/friction_law.hpp"

#include <algorithm>

namespace enduring {

//! [yamane_nakamura]
FrictionImpulse yamane_nakamura(const SlidingPair& pair, const YamaneNakamura& friction, double dt)
{
    const Vec2 held = -dt * (friction.spring * pair.stretch + friction.damper * pair.velocity);  // (5.22)
    if (held.norm() <= friction.mu_s * pair.normal_impulse)
        return {held, 0};

    const double speed = pair.velocity.norm();
    // (5.25)
    const double weight_over_speed = speed > 0 ? slip_weight(friction.weighting, speed) / speed
                                               : friction.weighting;
    return {-friction.mu_d * pair.normal_impulse * weight_over_speed * pair.velocity, speed};  // (5.23)
}
//! [yamane_nakamura]

Anchor anchor_of(const MassSplitting& friction, double inverse_mass, const Vec2& stretch, double dt)
{
    const double spring = std::min(friction.spring, 1 / (dt * dt * inverse_mass));
    return {spring, 2 * friction.damping_ratio * std::sqrt(spring / inverse_mass), stretch, dt};
}

double stretch_after_slip(double slip, double impulse, const MassSplitting& friction, double dt)
{
    return (1 - slip_weight(friction.weighting, slip)) * impulse / (dt * friction.spring);
}

//! [better_impulse]
FrictionImpulse better_impulse(const Vec2& impulse, const Vec2& velocity, double inverse_mass,
                               double normal_impulse, const Anchor& anchor, const MassSplitting& friction)
{
    const double response = inverse_mass + anchor.yielding();
    const Vec2 wanted = impulse - (velocity - anchor.held_velocity(impulse)) / response;
    const double length = wanted.norm(), most = friction.mu_s * normal_impulse;
    if (length <= most)
        return {wanted, 0};
    const double slip = response * (length - most);  // of the anchor, when mu_s has done its best
    const double mu = friction.mu_s - (friction.mu_s - friction.mu_d) * slip_weight(friction.weighting, slip);
    return {wanted * (mu * normal_impulse / length), slip};
}
//! [better_impulse]

}  // namespace enduring
