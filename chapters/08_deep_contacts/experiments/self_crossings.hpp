#pragma once

#include "common/simulation/body.hpp"
#include "common/simulation/rest_neighbours.hpp"

namespace enduring::chapter08 {

/// How many edges of a body's surface pass through its faces: every edge is asked about every face that is not
/// its neighbour in the rest shape, with exact signs. It uses no tree, no pair and no earlier step.
/// @param skin  the vertices are moved inwards by this first [m]: what is not deeper does not count
long self_crossings(const Body& body, const RestNeighbours& neighbours, double skin = 0);

}  // namespace enduring::chapter08
