#include "chapters/04_friction/friction_law.hpp"
#include "live/figures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::live {

Numbers slope(bool mass_splitting, double angle_deg, double mu_s, double mu_d, double damping, double seconds)
{
    constexpr double dt = 1e-3, gravity = 9.81, mass = 1;
    const double angle = angle_deg * std::numbers::pi / 180,
                 normal_impulse = mass * gravity * std::cos(angle) * dt;
    const double least = std::min(mu_d, mu_s), spring = 1000;
    const YamaneNakamura printed{
        .mu_s = mu_s, .mu_d = least, .spring = spring, .damper = 2 * damping * std::sqrt(spring * mass)};
    const MassSplitting splitting{.mu_s = mu_s, .mu_d = least, .spring = spring};
    Vec2 stretch = Vec2::Zero(), velocity = Vec2::Zero();
    double place = 0;
    Numbers result{1, 0};
    for (int i = 0; i * dt < seconds; ++i) {
        if (i % 10 == 0)
            result.push_back(place);
        velocity.x() += gravity * std::sin(angle) * dt;
        const FrictionImpulse answer =
            mass_splitting ? better_impulse(Vec2::Zero(), velocity, 1 / mass, normal_impulse,
                                            anchor_of(splitting, 1 / mass, stretch, dt), splitting)
                           : yamane_nakamura({stretch, velocity, normal_impulse}, printed, dt);
        velocity += answer.impulse / mass;
        stretch += dt * velocity;
        place += dt * velocity.x();
        if (answer.slip > 0) {
            result[0] = 0;
            const double longest = mass_splitting
                                       ? stretch_after_slip(answer.slip, answer.impulse.norm(), splitting, dt)
                                       : 0;
            stretch *= std::min(1.0, longest / std::max(stretch.norm(), 1e-12));
        }
        result[1] = std::max(result[1], answer.impulse.norm() / normal_impulse);
    }
    return result;
}

}  // namespace enduring::live
