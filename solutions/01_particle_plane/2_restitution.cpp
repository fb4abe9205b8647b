#include "exercises/01_particle_plane/2_restitution.hpp"

#include "chapters/01_particle_plane/plane_impulse.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring {

double damped_plane_impulse(double depth_t0, double depth_t1, double k, double c, double dt)
{
    const auto inside = find_plane_interval(depth_t0, depth_t1);
    if (!inside)
        return 0;
    const double change_in_the_step = depth_t1 - depth_t0;
    const double change_inside = (inside->end - inside->begin) * change_in_the_step;
    // A damper's impulse is the way that it was moved: the integral of c v over time.
    return continuous_plane_impulse(depth_t0, depth_t1, k, dt) - c * change_inside;
}

double damper_for_restitution(double restitution, double mass, double k, double dt)
{
    const double logarithm = std::log(restitution);
    const double ratio = -logarithm / std::sqrt(std::numbers::pi * std::numbers::pi + logarithm * logarithm);
    const double wanted = 2 * ratio * std::sqrt(k * mass);
    const double from_the_step = 0.5 * k * dt;
    return std::max(0.0, wanted - from_the_step);
}

double kept_by_a_bounce(double speed, double mass, double k, double c, double dt)
{
    double height = 0.5 * speed * dt, velocity = -speed;
    do {
        const double predicted = height + velocity * dt;
        velocity += damped_plane_impulse(height, predicted, k, c, dt) / mass;
        height += velocity * dt;
    } while (height < 0 || velocity < 0);
    return velocity / speed;
}

}  // namespace enduring
