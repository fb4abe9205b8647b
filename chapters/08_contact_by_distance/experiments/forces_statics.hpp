#pragma once

#include "chapters/08_contact_by_distance/experiments/forces_rows.hpp"

namespace enduring::chapter08::force_rows {

/// Bodies of 1 to 121 pairs, or 484 in full, on a plane and on boxes: the sum is their weight, and each force
/// k times its depth.
Rows weights(const MakeSolver& make, bool full);

/// Tables of four, five and six legs, with a load in the middle and beside it: sum, moments, and equal loads
/// of legs that are mirror images.
Rows tables(const MakeSolver& make, bool full);

/// Boxes with a symmetric grid of vertices: forces of mirror images are the same, whatever the floor's
/// triangles.
Rows mirror_images(const MakeSolver& make, bool full);

/// A stack, a pyramid of bricks and a heap: the ground carries their weight, and in a stack each box that of
/// those above.
Rows piles(const MakeSolver& make, bool full);

/// A box on a slope below the threshold: friction is m g sin, the normal force m g cos.
Rows slopes(const MakeSolver& make, bool full);

}  // namespace enduring::chapter08::force_rows
