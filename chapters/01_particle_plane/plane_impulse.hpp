#pragma once

#include <optional>

namespace enduring {

/// The part [begin, end] of a step in which a vertex is inside the ground, 0 <= begin <= end <= 1.
struct PlaneInterval {
    double begin = 0, end = 1;
};

/// Where a depth that changes linearly from depth_t0 to depth_t1 is negative (thesis 5.2.1, for the plane).
///
/// A straight way crosses a plane at most once, so there is at most one interval. A vertex that only touches
/// (depth 0) is not inside.
///
/// @param depth_t0, depth_t1  signed depth at both ends of the step [m], negative inside
/// @return                    nothing where the vertex stays outside
std::optional<PlaneInterval> find_plane_interval(double depth_t0, double depth_t1);

/// Discrete penalty impulse of a vertex in the ground: the force of the step's end, for the whole step.
///
/// @param depth_t1  signed depth at the predicted end of the step [m], negative inside
/// @param k         penalty stiffness [N/m], positive
/// @param dt        length of the step [s], positive
/// @return          impulse along the plane's normal [N s]; 0 outside: the ground never pulls
/// @see thesis (5.5) and (7.4)
double discrete_plane_impulse(double depth_t1, double k, double dt);

/// Continuous penalty impulse of a vertex in the ground: the force -k delta(tau), integrated over the part of
/// the step in which the vertex is inside.
///
/// @param depth_t0, depth_t1  signed depth at both ends of the step [m], negative inside, linear in between
/// @param k                   penalty stiffness [N/m], positive
/// @param dt                  length of the step [s], positive
/// @return                    impulse along the plane's normal [N s], never negative
/// @see thesis (5.19), (5.20) with the sign of (5.20) and the factor dt (errata)
double continuous_plane_impulse(double depth_t0, double depth_t1, double k, double dt);

}  // namespace enduring
