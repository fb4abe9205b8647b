#pragma once

#include "chapters/06_redefinition/experiments/make_solver.hpp"

namespace enduring::chapter06 {

/// A block of 20 kg laid on a slab of triangles, both turned together; without friction.
struct LaidBlock {
    double gap = 0;  ///< between them, but for rounding [m]
    double slope_deg = 10;
    double turned = 0.3;  ///< of the block, about the slab's normal [rad]
};

struct LaidOutcome {
    int corners_missed = 0;    ///< of four, after three steps: no pair holds them
    double energy_gained = 0;  ///< at most, over the energy at first [J]
};

/// 0.8 s with k = 12,000 N/m and steps of 0.01 s.
/// @param make_solver  this chapter's, or a later one's
LaidOutcome lay(const LaidBlock& laid, const MakeSolver& make_solver = chapter06_solver);

}  // namespace enduring::chapter06
