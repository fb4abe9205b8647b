#pragma once

#include "chapters/13_other_solvers/method_solver.hpp"

namespace enduring {

/// XPBD: in each of many substeps, positions and orientations are moved until no point is inside, contact by
/// contact; velocities are what the poses have moved by. Friction holds points where they were, and brakes
/// velocities. Nodes of soft bodies move with the elements around them (XpbdElements), and friction moves
/// them back by positions alone.
/// @param step  changed in place
/// @see Macklin, Mueller, Chentanez 2016, "XPBD", (18); Mueller et al. 2020, "Detailed rigid body simulation
///     with extended position based dynamics", algorithm 2, (2) to (9) and (25) to (34)
void xpbd(MethodStep& step, const XpbdSettings& settings);

Solver chapter13_xpbd_solver(const ContactParameters& parameters, const XpbdSettings& settings = {});

}  // namespace enduring
