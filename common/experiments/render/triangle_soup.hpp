#pragma once

#include "common/geometry/vector.hpp"

#include <vector>

namespace enduring {

/// One corner as the graphics library reads it. Single precision is enough here: positions are taken relative
/// to the stage's centre, and nothing that is drawn flows back into a computation.
struct Corner {
    Eigen::Vector3f position, normal, color;
    Eigen::Vector3f barycentric;  ///< 1 at this corner, for lines along the edges
};

/// Three corners a triangle, in a row.
using TriangleSoup = std::vector<Corner>;

}  // namespace enduring
