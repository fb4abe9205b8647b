#pragma once

#include "chapters/06_redefinition/experiments/make_solver.hpp"

namespace enduring::chapter06 {

/// What two free blocks gain in angular momentum together, over a collision in which one slides along the
/// other [kg m^2/s], and what the same impulses would give them with other levers.
struct LeverCost {
    Vec3 measured = Vec3::Zero();  ///< from the bodies
    Vec3 at_start = Vec3::Zero();  ///< the sum of (p - q) x I, with the places at the step's start
    Vec3 in_middle = Vec3::Zero();
    Vec3 at_end = Vec3::Zero();
    double pushed = 0;           ///< the sum of the impulses' lengths [N s]
    Vec3 linear = Vec3::Zero();  ///< linear momentum that they gain together [kg m/s]
};

/// A block of 20 kg comes down on one of 40 kg and slides along it, without weight.
struct FreeSlide {
    double dt;          ///< [s]
    double speed;       ///< along the other block [m/s]
    double gap = 5e-5;  ///< above it at first [m]; it comes down with 0.2 m/s
    FrictionParameters friction{};
};

/// @param make_solver  this chapter's, or a later one's
LeverCost cost_of_levers(const FreeSlide& slide, const MakeSolver& make_solver = chapter06_solver);

}  // namespace enduring::chapter06
