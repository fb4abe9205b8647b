#include "yamane_nakamura.hpp"

namespace enduring {

//! [yamane_nakamura]
FrictionImpulse yamane_nakamura(const SlidingPair& pair, const FrictionParameters& friction, double dt)
{
    const Vec2 held = -dt * (friction.spring * pair.stretch + friction.damper * pair.velocity);  // (5.22)
    if (held.norm() <= friction.mu_s * pair.normal_impulse)
        return {held, 0};

    const double speed = pair.velocity.norm();
    const double weight_over_speed = speed > 0 ? slip_weight(friction.weighting, speed) / speed : friction.weighting;  // (5.25)
    return {-friction.mu_d * pair.normal_impulse * weight_over_speed * pair.velocity, speed};  // (5.23)
}
//! [yamane_nakamura]

}  // namespace enduring
