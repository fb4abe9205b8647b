#pragma once

#include "common/simulation/body.hpp"

#include <algorithm>
#include <utility>

namespace enduring::chapter07 {

/// Least and largest coordinate of a body's vertices [m].
inline std::pair<double, double> extent(const Body& body, int axis)
{
    double least = 1e300, most = -1e300;
    for (const Vec3& x : body.positions_t0()) {
        least = std::min(least, x[axis]);
        most = std::max(most, x[axis]);
    }
    return {least, most};
}

}  // namespace enduring::chapter07
