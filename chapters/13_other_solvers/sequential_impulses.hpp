#pragma once

#include "chapters/13_other_solvers/method_solver.hpp"

namespace enduring {

/// Sequential impulses: the velocities of one contact after the other are made right, as if all others
/// stayed; again and again.
///
/// This is projected Gauss-Seidel on the velocities at the end of the step. The bound of friction is the
/// present normal impulse, direction by direction. Positions follow from velocities once, when the sweeps are
/// over.
/// @param step  changed in place
/// @see Catto 2006, "Iterative dynamics with temporal coherence"; Bullet's
/// btSequentialImpulseConstraintSolver
void sequential_impulses(MethodStep& step, const SequentialSettings& settings);

Solver chapter13_sequential_solver(const ContactParameters& parameters,
                                   const SequentialSettings& settings = {});

}  // namespace enduring
