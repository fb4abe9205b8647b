#pragma once

#include "common/simulation/body.hpp"
#include "common/simulation/rest_neighbours.hpp"

#include <vector>

namespace enduring::chapter10 {

/// How many edges of a body's surface pass through its faces: every edge is asked about every face that is
/// not its neighbour in the rest shape, with exact signs. It uses no tree, no pair and no earlier step.
/// @param skin  the vertices are moved inwards by this first [m]: what is not deeper does not count
long self_crossings(const Body& body, const RestNeighbours& neighbours, double skin = 0);

/// Where these edges pass through these faces, but for rounding [m].
std::vector<Vec3> self_crossing_points(const Body& body, const RestNeighbours& neighbours);

/// How thick a skin has to be taken off a body's surface until nothing of it crosses any more [m], to a tenth
/// or a micrometre, and at most 5 cm; from both sides of a crossing, so it is half as deep as they are in
/// each other.
/// @param known  no less than this is found [m]
double crossing_depth(const Body& body, const RestNeighbours& neighbours, double known = 0);

}  // namespace enduring::chapter10
