#pragma once

#include "common/simulation/body.hpp"

namespace enduring {

//! [own_directions]
/// Whether a vertex of a body has directions of its own, along which nothing of the body is further out. What
/// is flat is flat: a vertex inside a flat side has none, nor one on a straight ridge: what touches there,
/// touches the side or the ridge. So it does not matter how a side is cut into triangles. A corner has three
/// ridges, and the border of a sheet ends somewhere. What bends may have them, and so have all points of a
/// wire frame or a cloud.
bool has_own_directions(const Body& body, int vertex);

/// Whether the faces at an edge form a ridge.
bool is_ridge(const Body& body, int edge);

/// Whether a body's edges and vertices stay convex or flat as they are.
bool keeps_shape(const Body& body);
//! [own_directions]

}  // namespace enduring
