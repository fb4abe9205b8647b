#pragma once

namespace enduring {

/// A block that moves up and down over a floor at height 0.
struct BlockOnFloor {
    double mass;      ///< [kg]
    double height;    ///< of its underside [m], negative inside
    double velocity;  ///< [m/s]
};

/// The change of XPBD's multiplier that takes away an error, but for what the compliance leaves [kg m].
/// @param error       C [m], negative inside
/// @param multiplier  lambda so far in this substep [kg m]
/// @param response    w: how far a position impulse of 1 kg m moves the point [1/kg]
/// @param compliance  alpha, one over a stiffness [m/N]
/// @param dt          of the substep [s]
double multiplier_change(double error, double multiplier, double response, double compliance, double dt);

/// A substep of XPBD under gravity of 9.81 m/s^2: the block falls, then its position is corrected so many
/// times where it is inside, then its velocity is what it has moved by. The multiplier begins at zero.
BlockOnFloor substep(const BlockOnFloor& block, double compliance, double dt, int iterations);

/// How deep a block rests under these substeps [m].
double rest_depth(double mass, double compliance);

/// The compliance of each of so many equal contacts under a body, so that it rests at a depth [m/N].
double compliance_for(double mass, int contacts, double depth);

}  // namespace enduring
