#pragma once

namespace enduring {

/// The barrier over a distance: -(d - d_hat)^2 ln(d / d_hat) below d_hat, and 0 from there on [m^2].
/// @param distance  d [m], positive
/// @param d_hat     [m], positive
double barrier(double distance, double d_hat);

/// Its slope [m].
double barrier_slope(double distance, double d_hat);

/// The distance at which a barrier of stiffness kappa carries a load [m].
/// @param load   [N], positive
/// @param kappa  [N/m], positive: the force is kappa times minus the slope
double rest_distance(double load, double kappa, double d_hat);

/// The part of a change of the distance that a step may take [1]: the whole, or 0.8 of the time of impact.
/// @param change  [m]; negative towards the floor
double free_part(double distance, double change);

/// A block above a floor, and its end position without a barrier.
struct BlockOverFloor {
    double mass;      ///< [kg]
    double height;    ///< above the floor when the step begins [m], positive
    double falls_to;  ///< y: its height by inertia and gravity alone [m]; may lie far below the floor
};

/// The height at the end of the step [m]: the minimum of m / (2 dt^2) (x - y)^2 + kappa b(x) above the floor.
double step_end(const BlockOverFloor& block, double kappa, double d_hat, double dt);

}  // namespace enduring
