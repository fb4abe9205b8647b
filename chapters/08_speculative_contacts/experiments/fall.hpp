#pragma once

#include "chapters/07_implicit_contact/experiments/pile.hpp"

namespace enduring::chapter08 {

/// This chapter's solver or chapter 7's.
using MakeSolver = Solver (*)(const ContactParameters&, ImplicitSettings);

/// What cubes that fall come to.
struct FallOutcome {
    long pairs = 0;             ///< in the list after the last step
    double deepest_mm = 0;      ///< deepest vertex in the ground, after any step
    double speed_mm_per_s = 0;  ///< of the fastest cube at the end
    double energy_gain_j = 0;   ///< most that the energy rose above the first
    double newton_steps = 0;    ///< mean of a step
    chapter07::SolveStatistics solves;
};

/// Runs a scene on the plane y = 0; the observer, if any, sees the first state and each step.
/// @param duration  [s]
FallOutcome watch(Scene& scene, double duration, MakeSolver make, Probe* observer = nullptr);

}  // namespace enduring::chapter08
