#pragma once

#include "chapters/08_contact_by_distance/experiments/forces_rows.hpp"

namespace enduring::chapter08::force_rows {

/// A wedge of weight W between two planes without friction, which lean by a and b from the vertical: N_a = W
/// cos b / sin(a + b).
Rows wedges(const MakeSolver& make, bool full);

/// Two bars that lean against each other: a frame of three hinges, and its thrust.
Rows frames(const MakeSolver& make, bool full);

/// A half circle of stones: feet, thrust from joint to joint, forces and moments of each stone.
Rows arches(const MakeSolver& make, bool full);

/// Rings that hang through each other: each carries the weight below it.
Rows chains(const MakeSolver& make, bool full);

}  // namespace enduring::chapter08::force_rows
