#pragma once

#include "chapters/03_penalty_impulses/penetration.hpp"

namespace enduring {

// Two more ways to be rid of the normal's length. Both return the impulse on p [N s] of one pair over one
// step, as continuous_impulse does: from `start` in [0, 1], with the stiffness k [N/m] and the step dt [s].

/// A constant length again, but the mean is taken over each penetration interval instead of the whole step.
Vec3 impulse_by_length_of_visit(const PairStep& step, double start, double k, double dt);

/// No constant: the unit normal of each time, by three points of Gauss in
/// each of some equal pieces of every interval.
/// @param pieces  of each penetration interval, 1 or more
Vec3 impulse_by_unit_normals(const PairStep& step, double start, double k, double dt, int pieces);

/// What the unit normal costs: the first of 1, 2, 4, ... 64 pieces whose impulse twice as many pieces change
/// by at most the part `tolerance` of its length; 64 if none does. For a start of 0.
int pieces_for(const PairStep& step, double tolerance);

}  // namespace enduring
