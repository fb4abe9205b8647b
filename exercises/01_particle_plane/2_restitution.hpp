#pragma once

namespace enduring {

/// Impulse of a ground with a spring and a damper: the force -k delta - c d(delta)/dt,
/// integrated over the part of the step in which the particle is inside. It may pull a
/// little: the damper does, shortly before the particle leaves.
///
/// @param depth_t0, depth_t1  signed depth at both ends of the step [m], negative inside, linear in between
/// @param k                   spring [N/m], not negative
/// @param c                   damper [N s/m], not negative
/// @param dt                  length of the step [s], positive
/// @return                    impulse upwards [N s]; 0 for a particle that stays outside
double damped_plane_impulse(double depth_t0, double depth_t1, double k, double c, double dt);

/// The damper with which a bounce keeps a given part of its speed,
/// beyond the one that the step brings by itself.
///
/// @param restitution  speed after the bounce over speed before, in (0, 1]
/// @param mass         of the particle [kg]
/// @param k            spring [N/m]
/// @param dt           length of the step [s]
/// @return             c [N s/m]; 0 where the step's own damper k dt / 2 is already too strong
double damper_for_restitution(double restitution, double mass, double k, double dt);

/// What one bounce keeps: a particle that starts at the height 0.5 v dt with the velocity -v, without
/// gravity, and takes steps with damped_plane_impulse until it is outside and moves up.
///
/// @param speed  v before the bounce [m/s], positive
/// @return       speed after the bounce over speed before
double kept_by_a_bounce(double speed, double mass, double k, double c, double dt);

}  // namespace enduring
