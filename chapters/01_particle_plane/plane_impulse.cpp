#include "plane_impulse.hpp"

#include "plane_interval.hpp"

namespace enduring {

//! [discrete]
double discrete_plane_impulse(double depth_t1, double k, double dt)
{
    return depth_t1 < 0 ? -k * dt * depth_t1 : 0.0;
}
//! [discrete]

//! [continuous]
double continuous_plane_impulse(double depth_t0, double depth_t1, double k, double dt)
{
    const auto inside = find_plane_interval(depth_t0, depth_t1);
    if (!inside)
        return 0;
    // The depth is linear, so its integral is the depth in the middle of the interval times the interval's length.
    const double middle = 0.5 * (inside->begin + inside->end);
    const double depth_in_the_middle = depth_t0 + middle * (depth_t1 - depth_t0);
    return -k * dt * (inside->end - inside->begin) * depth_in_the_middle;
}
//! [continuous]

}  // namespace enduring
