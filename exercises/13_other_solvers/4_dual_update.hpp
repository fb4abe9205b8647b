#pragma once

namespace enduring {

/// A contact of AVBD after its block has touched the floor.
struct AugmentedContact {
    double multiplier;  ///< lambda [N], not negative
    double stiffness;   ///< k [N/m], positive
};

/// A block that moves up and down above a floor at height 0.
struct HeavyBlock {
    double mass;      ///< [kg]
    double height;    ///< of its underside [m], negative inside
    double velocity;  ///< [m/s]
};

/// After a sweep: the multiplier becomes the force, which never pulls, and the stiffness grows by beta |C|
/// where the force pushes.
/// @param error  C [m], positive where the block is inside
/// @param beta   growth of the stiffness per error [N/m^2]
AugmentedContact dual_update(const AugmentedContact& contact, double error, double beta);

/// The height at which the block ends under gravity of 9.81 m/s^2 [m]. The contact pushes with lambda + k C
/// while this is positive. The result minimises m / (2 dt^2) (x - y)^2 plus the contact's potential, where y
/// is the height after a free fall.
double primal_update(const HeavyBlock& block, const AugmentedContact& contact, double dt);

/// All sweeps of a step, each a primal and a dual update. @param contact  changed in place. @return  the
/// height [m]
double step_height(const HeavyBlock& block, AugmentedContact& contact, double beta, double dt, int sweeps);

/// The part of the multiplier's error that a sweep leaves, if the stiffness is constant [1].
double part_left(double mass, double stiffness, double dt);

}  // namespace enduring
