#pragma once

#include "chapters/02_collision_detection/surface_step.hpp"

#include <limits>

namespace enduring {

//! [swept_box]
/// The smallest axis-aligned box around everything that a feature passes through during a step.
///
/// A point that moves on a straight line stays between its two ends, and a point of an edge or a face between
/// its vertices, so the ends of the vertices' ways span it all. No sum is rounded on the way, and boxes are
/// closed: features that touch at any time have boxes that overlap.
/// @see thesis section 4.4
struct SweptBox {
    Vec3 low, high;

    static SweptBox empty()
    {
        const double infinity = std::numeric_limits<double>::infinity();
        return {Vec3::Constant(infinity), Vec3::Constant(-infinity)};
    }
    SweptBox grown_by(double margin) const
    {
        return {low - Vec3::Constant(margin), high + Vec3::Constant(margin)};
    }
    bool overlaps(const SweptBox& other) const
    {
        // counted, for the processor would often guess wrong at a branch for each axis
        return (low.array() <= other.high.array()).count() + (other.low.array() <= high.array()).count() == 6;
    }
};

inline SweptBox operator|(const SweptBox& a, const SweptBox& b)
{
    return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
}

inline SweptBox vertex_box(const SurfaceStep& surface, int vertex)
{
    const Vec3 &start = surface.start(vertex), &end = surface.end(vertex);
    return {start.cwiseMin(end), start.cwiseMax(end)};
}

inline SweptBox edge_box(const SurfaceStep& surface, int edge)
{
    const auto [a, b] = surface.edge(edge);
    return vertex_box(surface, a) | vertex_box(surface, b);
}

inline SweptBox face_box(const SurfaceStep& surface, int face)
{
    const auto [a, b, c] = surface.face(face);
    return vertex_box(surface, a) | vertex_box(surface, b) | vertex_box(surface, c);
}
//! [swept_box]

}  // namespace enduring
