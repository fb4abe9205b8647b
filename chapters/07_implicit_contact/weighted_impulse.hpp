#pragma once

namespace enduring {

/// The impulse of a straight path through the ground, and its derivative by the end of the path.
struct WayImpulse {
    double impulse = 0;  ///< along the normal [N s], never negative
    double slope = 0;    ///< d impulse / d depth_t1 [N s/m], never positive: a deeper end is pushed harder
};

/// Continuous penalty impulse with a weight over the step: -k dt times the
/// integral of weight(tau) min(0, depth(tau)).
///
/// The weight is a power of tau with the mean 1 and its centre at `centre`. So for a path that
/// lies inside altogether, the impulse is -k dt times the depth at tau = centre. 1/2 is chapter
/// 1's continuous impulse, in which all moments count equally; 1 its discrete one, in which
/// only the end counts; with 2/3 the weight grows as tau.
///
/// @param depth_t0, depth_t1  signed depth at both ends of the step [m], negative inside, linear in between
/// @param centre              of the weight, above 0 and at most 1
/// @param k                   penalty stiffness [N/m], positive
/// @param dt                  length of the step [s], positive
WayImpulse weighted_impulse(double depth_t0, double depth_t1, double centre, double k, double dt);

}  // namespace enduring
