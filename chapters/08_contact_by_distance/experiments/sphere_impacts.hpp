#pragma once

#include "chapters/08_contact_by_distance/experiments/driven_scenes.hpp"

namespace enduring::chapter08 {

/// A ball of facets comes down on the ground or on another ball, without gravity. Lengths along the
/// surface are positive in one direction, spins where they move the ball's lowest point in this direction.
struct SphereImpact {
    double normal_speed = 1;  ///< at which the surfaces meet [m/s]
    double along = 0;         ///< velocity of the ball along the surface [m/s]
    double spin = 0;          ///< of the ball [rad/s]
    double mu = 0.3;
    double restitution = 0;
    double other_radius = 0;  ///< of the other ball, of the same density and at rest; 0 is the ground [m]
    double other_spin = 0;    ///< of the other ball, in the ball's sense of turning [rad/s]
    double dt = 0.0005;       ///< [s]
    int subdivisions = 3;     ///< of both balls
    bool askew = false;       ///< a ball that lands on no vertex of its own, but turned by 0.3 rad
    double gap = 1.3e-4;      ///< at the start [m]; by default they meet within a step, not at the end of one
};

/// What the impact leaves of the ball's motion.
struct AfterImpact {
    AgainstFormula along;  ///< velocity along the surface [m/s]
    AgainstFormula rim;    ///< spin times radius [m/s]
    double rebound = 0;    ///< speed at which they part, over that at which they met
    double largest_off =
        0;  ///< of both velocities against the formula, over the speed at which the surfaces met
};

/// Radius of the ball [m].
inline constexpr double sphere_radius = 0.1;

/// By J_n = (1 + e) m v_n and J_t = min(mu J_n, m_t s): m is the reduced mass of both, s the slip, and 1/m_t
/// the sum of 1/m_i + r_i^2 / I_i; on the ground m_t = 2/7 of the ball's mass.
AfterImpact strike(const SphereImpact& impact);

/// A ball that is put down with 2 m/s and without spin, mu 0.3.
struct SlideToRoll {
    AgainstFormula time;   ///< by the rate at which its slip ends: 2 v_0 / (7 mu g) [s]
    AgainstFormula speed;  ///< when it rolls: 5/7 v_0 [m/s]
};
SlideToRoll slide_to_roll(double dt, int subdivisions);

/// Speed that a ball which rolls with 1 m/s has after half a second [m/s].
AgainstFormula keeps_rolling(double dt, int subdivisions);

}  // namespace enduring::chapter08
