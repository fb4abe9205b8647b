#include "plane_interval.hpp"

namespace enduring {

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

}  // namespace enduring
