#include "chapters/01_particle_plane/plane_impulse.hpp"

namespace enduring {

//! [discrete]
double discrete_plane_impulse(double depth_t1, double k, double dt)
{
    return depth_t1 < 0 ? -k * dt * depth_t1 : 0.0;
}
//! [discrete]

//! [interval]
std::optional<PlaneInterval> find_plane_interval(double depth_t0, double depth_t1)
{
    const bool inside_t0 = depth_t0 < 0, inside_t1 = depth_t1 < 0;
    if (!inside_t0 && !inside_t1)
        return {};
    if (inside_t0 && inside_t1)
        return PlaneInterval{0, 1};
    const double crossing = depth_t0 / (depth_t0 - depth_t1);  // the signs differ, so this lies in [0, 1]
    return inside_t0 ? PlaneInterval{0, crossing} : PlaneInterval{crossing, 1};
}
//! [interval]

//! [continuous]
double continuous_plane_impulse(double depth_t0, double depth_t1, double k, double dt)
{
    const auto inside = find_plane_interval(depth_t0, depth_t1);
    if (!inside)
        return 0;
    // The depth is linear, so its integral is the depth in the middle of
    // the interval times the interval's length.
    const double middle = 0.5 * (inside->begin + inside->end);
    const double depth_in_the_middle = depth_t0 + middle * (depth_t1 - depth_t0);
    return -k * dt * (inside->end - inside->begin) * depth_in_the_middle;
}
//! [continuous]

}  // namespace enduring
