#pragma once

#include "chapters/07_implicit_contact/experiments/pile.hpp"

namespace enduring::chapter07 {

/// A box at random that spins about an axis at random, just above a cube that lies on the ground.
/// @param turn  in a step [rad]
Scene spinning_box(double turn, double dt, unsigned seed);

/// The most energy in 50 steps, over that at first.
/// @param most_turn  of the solver [rad]
/// @param solves     its solves are added
double most_energy(Scene scene, MakeSolver make, double most_turn, SolveStatistics& solves);

}  // namespace enduring::chapter07
