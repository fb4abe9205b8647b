#pragma once

#include "chapters/05_categorisation/normal_span.hpp"

#include <array>
#include <optional>

namespace enduring {

/// Where a walk over a surface ended.
struct Walk {
    int face;                       ///< on which the foot lies
    std::array<double, 3> weights;  ///< of the foot, none below -1e-12
    int crossed;                    ///< edges on the way
};

/// Barycentric weights of a point dropped at right angles onto the plane of a face. They sum to 1.
/// @throws std::domain_error  a face without area
std::array<double, 3> foot_weights(const SurfaceMoment& surface, int face, const Vec3& point);

/// Follows a point that may have left its face by more than one edge in a step: as long
/// as the foot lies beside the face, go on to the neighbour across the edge that it is
/// farthest beyond (opposite the most negative weight).
///
/// @param face   where it began
/// @param point  [m]
/// @return       nothing when the walk comes to an open border, or crosses more than `most` edges
std::optional<Walk> walk_to_foot(const SurfaceMoment& surface, int face, const Vec3& point, int most = 100);

}  // namespace enduring
