#pragma once

#include "chapters/09_deep_contacts/overlaps.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// Appends a pair for each two edges that cross on the border of an overlap and have none, where everything lies
/// at the start of the step: both feet lie on their edges, inside the other body, and the pair pushes along the
/// separation direction, give or take 45 degrees. The pairs endure.
///
/// Where the corners of two boxes lie beside each other there is no vertex in either box, and nothing but two edges
/// that hold them apart.
/// @param overlap  of body_a with body_b, places in World::bodies
void append_crossing_edges(const World& world, int body_a, int body_b, const Overlap& overlap,
                           Contacts& contacts);

}  // namespace enduring
