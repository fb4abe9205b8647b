#pragma once

namespace enduring {

/// A block that moves up and down above a floor at height 0.
struct BlockOnFloor {
    double mass;      ///< [kg]
    double height;    ///< of its underside [m], negative inside
    double velocity;  ///< [m/s]
};

/// The change of XPBD's multiplier that removes an error, except for the part left by the compliance [kg m].
/// @param error       C [m], negative inside
/// @param multiplier  lambda so far in this substep [kg m]
/// @param response    w: displacement of the point by a position impulse of 1 kg m [1/kg]
/// @param compliance  alpha, one over a stiffness [m/N]
/// @param dt          of the substep [s]
double multiplier_change(double error, double multiplier, double response, double compliance, double dt);

/// A substep of XPBD under gravity of 9.81 m/s^2: the block falls; where it is inside, its position is
/// corrected `iterations` times; then its velocity is its displacement over dt. The multiplier begins at 0.
BlockOnFloor substep(const BlockOnFloor& block, double compliance, double dt, int iterations);

/// The velocity after an implicit step of length dt of a block on a spring of stiffness 1 / compliance: the
/// spring acts at the height where the step ends, and gravity of 9.81 m/s^2 throughout [m/s].
/// @param compliance  above 0 [m/N]
double implicit_velocity(const BlockOnFloor& block, double compliance, double dt);

/// The depth at which a block rests under these substeps [m].
double rest_depth(double mass, double compliance);

/// The compliance of each of `contacts` equal contacts under a body with which it rests at this depth [m/N].
double compliance_for(double mass, int contacts, double depth);

}  // namespace enduring
