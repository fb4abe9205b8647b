#pragma once

#include "chapters/05_categorisation/normal_span.hpp"

namespace enduring {

/// The sine of the angle by which a surface folds at an edge, at right angles to it: positive where its two faces form
/// a valley, negative where they form a ridge. An open border is a ridge of -1.
double fold_at_edge(const SurfaceMoment& surface, int edge);

//! [cones]
/// Whether a direction lies in the normal cone of a vertex: whether a plane across it can touch the surface there and
/// has all of the vertex' neighbours behind it. So a vertex between hills and valleys has none, and one in a hollow none
/// that leads out. Which side of the surface is the outer one is not asked: an impact may turn a soft body inside out.
/// @param direction  unit length
/// @param sine       by which a neighbour may pass the plane
bool in_cone_of_vertex(const SurfaceMoment& surface, int vertex, const Vec3& direction, double sine);

/// The same for an edge and its two faces. An edge that is not convex has none.
/// @param least_fold  sine of the angle from which an edge counts as convex
bool in_cone_of_edge(const SurfaceMoment& surface, int edge, const Vec3& direction, double sine,
                     double least_fold);
//! [cones]

}  // namespace enduring
