#pragma once

#include "chapters/05_categorisation/normal_span.hpp"

namespace enduring {

/// The sine of the angle by which a surface folds at an edge, at right angles to it: positive where its two
/// faces form a valley, negative where they form a ridge. An open border is a ridge of -1.
double fold_at_edge(const SurfaceMoment& surface, int edge);

//! [cones]
/// Whether a direction lies in the normal cone of a vertex: whether no neighbour of the vertex is further
/// along. So a vertex in a hollow and one between hills and valleys have none. It does not ask for the outer
/// side, which an impact may turn inwards.
/// @param direction  unit length, out of the body
/// @param sine       by which a neighbour may pass the plane across it
bool is_foremost(const SurfaceMoment& surface, int vertex, const Vec3& direction, double sine);

/// As for a vertex, for an edge and its two faces. An edge that is not convex has none.
/// @param least_fold  sine of the angle from which an edge counts as convex
bool in_cone_of_edge(const SurfaceMoment& surface, int edge, const Vec3& direction, double sine,
                     double least_fold);
//! [cones]

}  // namespace enduring
