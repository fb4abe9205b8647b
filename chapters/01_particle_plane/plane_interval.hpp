#pragma once

#include <optional>

namespace enduring {

/// The part [begin, end] of a step in which a vertex is inside the ground, 0 <= begin <= end <= 1.
struct PlaneInterval {
    double begin = 0, end = 1;
};

/// Where a depth that changes linearly from depth_t0 to depth_t1 is negative (thesis 5.2.1, for the plane).
///
/// A straight way crosses a plane at most once, so there is at most one interval. A vertex that only touches
/// (depth 0) is not inside.
///
/// @param depth_t0, depth_t1  signed depth at both ends of the step [m], negative inside
/// @return                    nothing where the vertex stays outside
std::optional<PlaneInterval> find_plane_interval(double depth_t0, double depth_t1);

}  // namespace enduring
