#pragma once

#include "chapters/05_categorisation/experiments/corner.hpp"

#include <array>

namespace enduring::chapter05 {

/// Your prediction, written down before anything is measured: from which part of all directions a board can
/// touch the corner of a cube with its tip, between 0 and 1.
double predicted_share();

/// `count` directions that cover the sphere evenly: a spiral from pole to pole. The i-th stands at the height
/// y = 1 - (2 i + 1) / count, and is turned about the y axis by i times the golden angle pi (3 - sqrt(5)).
std::vector<Vec3> even_directions(int count);

/// The part of these directions in which a board can touch a corner (can_touch says so).
double measured_share(const Corner& corner, int count);

/// The law for a corner of three faces: the part of the sphere that the
/// spherical triangle of their normals covers.
/// @param normals  unit vectors
/// @see A. van Oosterom and J. Strackee, 1983
double law_of_share(const std::array<Vec3, 3>& normals);

}  // namespace enduring::chapter05
