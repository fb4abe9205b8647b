#pragma once

#include "chapters/11_exact_contact/friction_problem.hpp"

namespace enduring {

/// Which rule a contact keeps: the nearest point of the cone to r - u~, or its convex relaxation, to r - u.
/// The relaxation is the condition of a convex problem: minimise 1/2 r^T W r + q^T r over the cones. It lifts
/// what slips: u_n = mu |u_t|. A. Castro, F. Permenter, X. Han: An unconstrained convex formulation of
/// compliant contact, IEEE Transactions on Robotics 39, 2023.
enum class FrictionRule { coulomb, relaxed };

/// Impulses of few contacts by projection alone: r <- P(r - rho (u + lift)), until nothing changes. Slow, and
/// without springs: what the formulas of the chapter say, in one line.
/// @return  r; the last iterate after 100,000 of them
Eigen::VectorXd projected_impulses(const FrictionProblem& problem, FrictionRule rule);

/// A block of 1 kg over the ground.
struct SlidingBlock {
    double gap = 0;     ///< [m]
    double speed = 0;   ///< along the ground [m/s]
    double rising = 0;  ///< [m/s]
};
/// Where it is and how it moves after a step under its weight, whose contact keeps the gap at the end from
/// being negative.
SlidingBlock after_step(const SlidingBlock& block, double mu, double dt, FrictionRule rule);

/// The contact of a slender rod of 1 kg and length 2 m whose lower end slides: 2D, u = W r + q. Where mu > (1
/// + 3 cos^2 a) / (3 sin a cos a), friction presses the rod into the ground as fast as the ground can push:
/// its slip stops at once, though nothing has hit anything. The least such mu is 4/3, at tan a = 2. P.
/// Painleve: Sur les lois du frottement de glissement, Comptes rendus de l'Academie des Sciences 121, 1895.
/// @param angle  a, of the rod against the ground [rad]
/// @param speed  of the end along the ground, which slides ahead of the rod [m/s]
/// @param fall   of the end in the step without the ground [m/s]; negative where it leaves the ground
FrictionProblem sliding_rod(double angle, double mu, double speed, double fall);

/// (1 + 3 cos^2 a) / (3 sin a cos a).
double painleve_friction(double angle);

}  // namespace enduring
