#pragma once

#include "common/simulation/step.hpp"

namespace enduring {

/// Your prediction, written down before anything is measured: how often the vertex' pair changes its face, on
/// a slide over 10 cells along x and 3 along z.
double predicted_changes();

/// A tip just below a floor of cells of 1 m, all cut along the same diagonal, that
/// slides without gravity and without being pushed back.
/// @param velocity  of the tip along x and z [m/s]
World sliding_tip(double velocity_x, double velocity_z);

/// Counts, step by step, how often the face of the tip's pair is another one than in the step before. The
/// pair is the vertex-face contact whose body_a is 1 and whose feature_a is 0; its face is feature_b. Steps
/// without a pair change nothing.
///
/// @param world  from sliding_tip
/// @param steps  of dt each, with chapter 6's solver
/// @param dt     [s]
int measured_changes(World& world, int steps, double dt);

/// The law: how many borders a straight way over such a floor crosses,
/// those between cells and those within them.
/// @param cells_x, cells_z  signed lengths of the way [cells]
double law_of_changes(double cells_x, double cells_z);

}  // namespace enduring
