#pragma once

#include "chapters/08_contact_by_distance/experiments/forces_rows.hpp"

namespace enduring::chapter08::force_rows {

/// Soft blocks that lie: on a plane, on a box, on each other: the sum of their forces is the weight.
Rows soft_weights(const MakeSolver& make, bool full);

/// A soft block between two plates, without friction: the strain is the same everywhere, so each vertex has
/// its share of the area, and the sum is Young's modulus times area and strain.
Rows soft_pressure(const MakeSolver& make, bool full);

/// A soft ball between two plates that come nearer by d: 4/3 E / (1 - nu^2) sqrt(R) (d / 2)^(3/2).
/// @see Johnson: Contact Mechanics, 1985, section 4.2
Rows hertz(const MakeSolver& make, bool full);

}  // namespace enduring::chapter08::force_rows
