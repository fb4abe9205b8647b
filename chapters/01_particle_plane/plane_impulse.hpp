#pragma once

namespace enduring {

/// Discrete penalty impulse of a vertex in the ground: the force of the step's end, for the whole step.
///
/// @param depth_t1  signed depth at the predicted end of the step [m], negative inside
/// @param k         penalty stiffness [N/m], positive
/// @param dt        length of the step [s], positive
/// @return          impulse along the plane's normal [N s]; 0 outside: the ground never pulls
/// @see thesis (5.5) and (7.4)
double discrete_plane_impulse(double depth_t1, double k, double dt);

/// Continuous penalty impulse of a vertex in the ground: the force -k delta(tau), integrated over the part of the step
/// in which the vertex is inside.
///
/// @param depth_t0, depth_t1  signed depth at both ends of the step [m], negative inside, linear in between
/// @param k                   penalty stiffness [N/m], positive
/// @param dt                  length of the step [s], positive
/// @return                    impulse along the plane's normal [N s], never negative
/// @see thesis (5.19), (5.20) with the sign of (5.20) and the factor dt (errata)
double continuous_plane_impulse(double depth_t0, double depth_t1, double k, double dt);

}  // namespace enduring
