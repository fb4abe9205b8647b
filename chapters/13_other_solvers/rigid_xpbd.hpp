#pragma once

#include "chapters/13_other_solvers/rigid_step.hpp"

namespace enduring {

/// XPBD for rigid bodies: in each of many substeps, positions and orientations are moved until no point is inside, contact by contact; velocities
/// are what the poses have moved by. Friction holds points where they were, and brakes velocities.
/// @param step  changed in place
/// @see Macklin, Mueller, Chentanez 2016, "XPBD", (18); Mueller et al. 2020, "Detailed rigid body simulation with extended position based
///     dynamics", algorithm 2, (2) to (9) and (25) to (34)
void rigid_xpbd(RigidStep& step, const XpbdSettings& settings);

Solver chapter13_xpbd_solver(const ContactParameters& parameters, const XpbdSettings& settings = {});

}  // namespace enduring
