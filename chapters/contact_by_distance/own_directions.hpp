#pragma once

#include "chapters/02_collision_detection/surface_step.hpp"

#include <vector>

namespace enduring {

//! [own_directions]
/// Which features of a body have directions of their own, along which nothing of the body is further out than they are. What is flat
/// is flat: an edge inside a flat side has none, nor has a vertex whose faces lie in one plane, nor a vertex in a hollow of which no edge
/// is convex. A body that keeps its shape is asked once.
struct OwnDirections {
    std::vector<bool> of_vertex;

    explicit OwnDirections(const Body& body);
};

/// Whether the faces at an edge form a ridge.
bool is_ridge(const Body& body, int edge);

/// Whether a body's edges and vertices stay convex or flat as they are.
bool keeps_shape(const Body& body);
//! [own_directions]

}  // namespace enduring
