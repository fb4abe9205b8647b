#include "chapters/07_implicit_contact/weighted_impulse.hpp"

#include "chapters/01_particle_plane/plane_impulse.hpp"

#include <cmath>

namespace enduring {

//! [weighted_impulse]
WayImpulse weighted_impulse(double depth_t0, double depth_t1, double centre, double k, double dt)
{
    const auto inside = find_plane_interval(depth_t0, depth_t1);
    if (!inside)
        return {};
    // The weight p tau^(p-1) has its centre at p / (p + 1), and these are the integrals
    // up to tau of weight times depth, and of weight times tau. The ends of the
    // interval move with depth_t1 too, but there the depth is 0.
    const double p = centre / (1 - centre);
    const auto weight_until = [&](double tau) { return tau == 0 || tau == 1 ? tau : std::pow(tau, p); };
    const double at_end = weight_until(inside->end), at_begin = weight_until(inside->begin);
    const auto mean_depth = [&](double tau) { return depth_t0 + centre * tau * (depth_t1 - depth_t0); };
    return {-k * dt * (at_end * mean_depth(inside->end) - at_begin * mean_depth(inside->begin)),
            -k * dt * centre * (at_end * inside->end - at_begin * inside->begin)};
}
//! [weighted_impulse]

}  // namespace enduring
