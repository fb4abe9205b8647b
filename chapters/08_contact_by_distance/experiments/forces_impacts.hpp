#pragma once

#include "chapters/08_contact_by_distance/experiments/forces_rows.hpp"

namespace enduring::chapter08::force_rows {

/// Scenes with bodies on bodies, in one order and in the other: each pair of bodies has the same forces in
/// each step.
Rows either_order(const MakeSolver& make, bool full);

/// Boxes and balls that land and bounce: in each whole step the forces times dt are the change of momentum,
/// less gravity's.
Rows momentum_of_impacts(const MakeSolver& make, bool full);

/// Balls that drop straight: no spin, and the largest force times dt is (1 + e) m v.
Rows straight_drops(const MakeSolver& make, bool full);

/// A rod that lands on its end, without friction.
Rows rods_on_end(const MakeSolver& make, bool full);

/// A ball that strikes two others at once, and one with backspin that strikes a wall.
Rows struck_balls(const MakeSolver& make, bool full);

}  // namespace enduring::chapter08::force_rows
