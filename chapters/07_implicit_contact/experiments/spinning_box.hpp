#pragma once

#include "chapters/07_implicit_contact/experiments/pile.hpp"

namespace enduring::chapter07 {

/// A box at random that spins about an axis at random, just above a cube that lies on the ground.
/// @param turn  in a step [rad]
Scene spinning_box(double turn, double dt, unsigned seed);

/// The most energy in 50 steps, over that at first.
/// @param max_turn  of the solver [rad]
/// @param solves     its solves are added
double max_energy(Scene scene, MakeSolver make, double max_turn, SolveStatistics& solves);

}  // namespace enduring::chapter07
