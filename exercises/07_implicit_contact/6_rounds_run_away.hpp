#pragma once

namespace enduring {

/// A cube that slides down between two walls. Both lean by the same angle, and each has one pair with the
/// cube. So the cube moves only up and down, and both pairs behave the same.
struct Wedge {
    double mass;        ///< [kg]
    double stiffness;   ///< k of each of the two pairs [N/m]
    double angle;       ///< between each wall and the vertical [rad], between 0 and pi/2
    double mu;          ///< of each pair
    double free_speed;  ///< downwards, at the end of the step without walls [m/s], positive
    double dt;          ///< [s]
};

/// The result of one step. At its start both pairs just touch, and their springs are not stretched.
struct WedgeMotion {
    double speed;     ///< of the cube, downwards, at the end of the step [m/s]
    double normal;    ///< size of the impulse of one wall along its normal [N s]
    double friction;  ///< size of the impulse of one wall along its surface, upwards [N s]
};

/// The solution of one round: both pairs have the same given limit of friction.
/// @param limit  [N s]
WedgeMotion solved_with(const Wedge& wedge, double limit);

/// The number of rounds from a limit of zero on. A round solves with the limit and compares it with mu times
/// the normal impulse found. If the two differ by at most the tolerance, this round is the last. Otherwise
/// the limit changes by a part of the difference.
/// @param part       of the difference; 1: the limit becomes mu times the normal impulse
/// @param tolerance  [N s]
/// @return the number of rounds, including the last; 0 if `most` rounds are not enough
int rounds_needed(const Wedge& wedge, double part, double tolerance, int most);

/// The factor c by which a round with part 1 multiplies the error of the limit, as long as the cube slips.
double factor_of_a_round(const Wedge& wedge);

/// The part with which one change makes the limit exact.
double best_part(const Wedge& wedge);

/// Your prediction: between very stiff walls at this angle, the smallest coefficient for which rounds with
/// part 1 do not converge.
double predicted_mu(double angle);

}  // namespace enduring
