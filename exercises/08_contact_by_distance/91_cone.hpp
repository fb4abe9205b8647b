#pragma once

#include "common/geometry/vector.hpp"

#include <vector>

namespace enduring {

/// A place at which one body may push another one, in the direction of a normal of unit length.
struct Push {
    int key;
    Vec3 point;   ///< [m]
    Vec3 normal;  ///< unit length
};

/// Whether a direction lies in the normal cone of a vertex: no neighbour stands before the plane across it,
/// by more than a sine.
/// @param d  unit length
bool in_cone(const Vec3& x, const std::vector<Vec3>& neighbours, const Vec3& d, double sine);

/// The same for an edge from a to b with the third corners of its two faces. Along the edge, both ends are
/// neighbours of each other; of a face only what is at right angles to the edge counts, so its third corner
/// may lie anywhere along the edge.
bool in_cone_of_edge(const Vec3& a, const Vec3& b, const Vec3& left, const Vec3& right, const Vec3& d,
                     double sine);

/// The pushes in the order of their keys, without those that act along the line of an earlier one: their
/// normals are parallel (or opposite) to a sine of 1e-6, and their points are no farther from this line than
/// apart [m].
std::vector<Push> one_of_each_line(std::vector<Push> pushes, double apart);

}  // namespace enduring
