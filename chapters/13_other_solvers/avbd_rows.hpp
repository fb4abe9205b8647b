#pragma once

#include "chapters/13_other_solvers/method_step.hpp"
#include "chapters/13_other_solvers/settings.hpp"

#include <array>

namespace enduring {

//! [dual_update]
/// A hard constraint of AVBD: its multiplier, and the stiffness that grows as long as it is not met.
struct AugmentedConstraint {
    double multiplier = 0;  ///< lambda [N]
    double stiffness = 0;   ///< k [N/m]
};
/// Behind a sweep: the multiplier becomes the force, and the stiffness grows by beta |C| where the force is
/// not at a bound.
/// @param error   C [m]
/// @param least, most  bounds of the force [N]
/// @see Giles, Diaz, Yuksel 2025, "Augmented vertex block descent", (11), (12) and (16)
AugmentedConstraint dual_update(const AugmentedConstraint& constraint, double error, double least,
                                double most, const AvbdSettings& settings);
//! [dual_update]

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// From one pose to another: the way of the centre [m], and the rotation vector [rad].
Vector6 way_between(const Pose& from, const Pose& to);

//! [avbd_row]
/// A contact's three constraints: C = C_0 - alpha C_0 + J (x - x_0) to first order (18), positive where the
/// contact has to push.
struct AvbdRow {
    const ContactPoint* point;
    std::array<Vec3, 3> directions;  ///< the normal and the tangents
    std::array<Vector6, 3> j_a,
        j_b;  ///< of rigid bodies, with the levers of the start; of a soft one, each node moves by its weight
    Vec3 start = Vec3::Zero();  ///< errors without any motion of the bodies [m]
    Vec3 slip = Vec3::Zero();   ///< when the step begins, along the surface [m]
    std::array<AugmentedConstraint, 3> constraints{};
    bool slips = true;  ///< behind the last sweep

    AvbdRow(const MethodStep& step, const ContactPoint& of);
    /// C of row i now [m].
    double error(const MethodStep& step, int i) const;
    struct Push {
        Vec3 force;    ///< along the three directions [N]
        bool is_full;  ///< of friction
    };
    /// Along the normal from 0 on; along the surface within a disc of mu times the normal force.
    Push push(const MethodStep& step) const;
    /// Behind a sweep: all three multipliers and stiffnesses.
    void update(const MethodStep& step, const AvbdSettings& settings);
};
//! [avbd_row]

}  // namespace enduring
