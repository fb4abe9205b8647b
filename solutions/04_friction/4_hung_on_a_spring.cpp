#include "exercises/04_friction/4_hung_on_a_spring.hpp"

#include "chapters/04_friction/friction_law.hpp"

#include <cmath>

namespace enduring {

double predicted_ratio() { return 2; }

bool holds_the_block(double ratio, double damping)
{
    const double slope = 0.2, gravity = 9.81, dt = 1e-4;  // rad, m/s^2, s
    YamaneNakamura friction;
    friction.mu_s = friction.mu_d = ratio * std::tan(slope);
    friction.spring = 1000;
    friction.damper = 2 * damping * std::sqrt(friction.spring);
    double stretch = 0, velocity = 0;
    for (int step = 0; step < 20000; ++step) {
        velocity += gravity * std::sin(slope) * dt;
        const SlidingPair pair{{stretch, 0}, {velocity, 0}, gravity * std::cos(slope) * dt};
        const FrictionImpulse answer = yamane_nakamura(pair, friction, dt);
        if (answer.slip > 0)
            return false;
        velocity += answer.impulse.x();
        stretch += velocity * dt;
    }
    return true;
}

double smallest_ratio(double damping)
{
    double low = 1, high = 3;
    while (high - low > 1e-3) {
        const double middle = 0.5 * (low + high);
        (holds_the_block(middle, damping) ? high : low) = middle;
    }
    return high;
}

double overshoot_law(double damping)
{
    return 1 + std::exp(-2 * damping * std::acos(damping) / std::sqrt(1 - damping * damping));
}

}  // namespace enduring
