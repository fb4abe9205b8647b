#pragma once

#include "common/geometry/vector.hpp"

#include <optional>

namespace enduring {

/// An edge of a surface, from p to q, with the third corners of its two faces. Seen from outside, (p, q, left) and
/// (q, p, right) run counter-clockwise.
struct FoldedEdge {
    Vec3 p, q, left, right;
};

enum class FoldKind { ridge, flat, valley };

/// From the edge into the left (or the right) face, at right angles to the edge, unit length.
Vec3 into_left(const FoldedEdge& edge);
Vec3 into_right(const FoldedEdge& edge);

/// Sine of the angle by which the surface folds at the edge: positive in a valley, negative at a ridge.
double fold_of(const FoldedEdge& edge);

/// What that makes of the edge.
/// @param least  sine from which an edge counts as folded
FoldKind kind_of(const FoldedEdge& edge, double least);

/// Whether the edge can push in a direction: it is a ridge, the direction looks out of one of its faces, and neither
/// face passes a plane across the direction by more than the sine.
/// @param direction  unit length
bool can_push(const FoldedEdge& edge, const Vec3& direction, double least, double sine);

/// The normal of a pair of two edges: at right angles to both, unit length, out of B and into A. None if they are
/// closer to parallel than `parallel` (a sine), or if one of the two cannot push that way.
std::optional<Vec3> normal_of_pair(const FoldedEdge& a, const FoldedEdge& b, double least, double sine,
                                   double parallel);

}  // namespace enduring
