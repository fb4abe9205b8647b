#pragma once

#include "chapters/13_other_solvers/method_solver.hpp"

namespace enduring {

//! [softness]
/// A soft constraint: a damped spring, integrated implicitly, as a velocity constraint with three numbers.
struct Softness {
    double bias_rate = 0;      ///< velocity per depth with which it goes [1/s]
    double mass_scale = 1;     ///< of the impulse that makes the velocity right [1]
    double impulse_scale = 0;  ///< part of the sum of impulses that leaks away [1]
};
/// @param hertz          frequency of the spring [1/s]; 0 is a rigid constraint
/// @param damping_ratio  of critical [1]
/// @param h              length of a substep [s]
/// @see Catto 2011, "Soft constraints", with omega = 2 pi hertz; b2MakeSoft in Box2D 3
Softness softness(double hertz, double damping_ratio, double h);
//! [softness]

/// The soft step: substeps with one sweep of soft contacts each, and one without springs behind the move
/// ("relax").
/// @param step  changed in place
/// @see Catto 2024, "Solver2D"; Box2D 3, src/contact_solver.c
void soft_step(MethodStep& step, const SoftStepSettings& settings);

Solver chapter13_soft_step_solver(const ContactParameters& parameters, const SoftStepSettings& settings = {});

}  // namespace enduring
