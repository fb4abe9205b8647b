#pragma once

#include "chapters/13_other_solvers/rigid_step.hpp"

#include <map>
#include <vector>

namespace enduring {

//! [dual_update]
/// A hard constraint of AVBD: its multiplier, and the stiffness that grows as long as it is not met.
struct AugmentedConstraint {
    double multiplier = 0;  ///< lambda [N]
    double stiffness = 0;   ///< k [N/m]
};
/// Behind a sweep: the multiplier becomes the force, and the stiffness grows by beta |C| where the force is not at a bound.
/// @param error   C [m]
/// @param least, most  bounds of the force [N]
/// @see Giles, Diaz, Yuksel 2025, "Augmented vertex block descent", (11), (12) and (16)
AugmentedConstraint dual_update(const AugmentedConstraint& constraint, double error, double least,
                                double most, const AvbdSettings& settings);
//! [dual_update]

/// Augmented vertex block descent for rigid bodies: one body after the other goes to the minimum of its own energy, six coordinates at a time,
/// as if all others stayed; behind each sweep the multipliers of all contacts follow.
class RigidAvbd {
public:
    explicit RigidAvbd(const AvbdSettings& settings) : settings_(settings) {}
    /// @param step  changed in place
    void operator()(RigidStep& step);

private:
    struct Row;
    std::vector<Row> rows_of(const RigidStep& step) const;
    void guess(RigidStep& step);
    void keep(RigidStep& step, const std::vector<Row>& rows);

    /// Of a pair, from step to step.
    struct Kept {
        Vec3 stiffness;  ///< of its three rows [N/m]
        Vec3 slip;       ///< from where friction holds it, along the surface, in the axes of A [m]
    };

    AvbdSettings settings_;
    std::map<PairKey, Kept> kept_;
    std::vector<Vec3> velocities_;  ///< when the last step began [m/s]
};

Solver chapter13_avbd_solver(const ContactParameters& parameters, const AvbdSettings& settings = {});

}  // namespace enduring
