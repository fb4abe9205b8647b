#pragma once

#include "chapters/07_implicit_contact/experiments/pile.hpp"

namespace enduring::chapter07 {

/// How deep the bodies of a run come into each other, whatever its pairs say, and how well its steps were
/// solved. Plain numbers, to be kept by sweep().
struct DepthOutcome {
    double deepest_m = 0;  ///< after any step
    double at_end_m = 0;   ///< after the last one
    double size_m = 0;     ///< of the smallest body that moves
    /// the most energy that a step brings to bodies and springs, over what the scene began with
    double gain = 0;
    int lost = 0;  ///< bodies whose middle is behind a plane at the end
    long unsolved = 0, solves = 0;
    int max_newton_steps = 0;

    void add(const DepthOutcome& other);
};

/// Runs a scene with one of the solvers, and measures it after every step.
/// @param duration  [s]
DepthOutcome measure_depths(Scene& scene, double duration, MakeSolver make);

}  // namespace enduring::chapter07
