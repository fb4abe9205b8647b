#pragma once

#include "common/simulation/step.hpp"

namespace enduring {

/// One step in numbers small enough to check by hand (the book's page on the worked step).
///
/// A sheet of four points, "below", lies at rest in y = 0; its faces 0 and 1 share a diagonal. A triangle,
/// "above", touches it with three vertices, one pair each:
///   vertex 0  dives through face 0 in the middle of the step     a new pair
///   vertex 1  has been under face 0 since an earlier step        an enduring pair
///   vertex 2  still belongs to face 0 but lies under face 1      an enduring pair that is redefined
/// All points weigh 1 kg; there is no gravity; k dt = 1 N s/m, so
/// that an impulse is the area above the depth.
struct WorkedStep {
    World world;
    Contacts contacts;      ///< the two enduring pairs, as the step before left them
    double dt = 0.1;        ///< [s]
    double stiffness = 10;  ///< k of one pair [N/m]
};

WorkedStep worked_step();

/// Stand-ins for what the chapters build: they know vertex-face pairs of body 0 on body
/// 1 alone, and integrate exactly only while the face rests. A chapter puts its own
/// passes in their place and must get the same numbers.
Pass stand_in_resolve();  ///< drops pairs whose depth is positive
/// moves a vertex that has left its face on to the neighbour
Pass stand_in_redefine();
Pass stand_in_detect();                   ///< finds vertices that pass through a face from outside
Pass stand_in_respond(double stiffness);  ///< normal impulses from the mean depth
Solver worked_step_solver(double stiffness);

}  // namespace enduring
