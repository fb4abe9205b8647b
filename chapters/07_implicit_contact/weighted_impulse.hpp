#pragma once

namespace enduring {

/// What a straight way through the ground charges, and how that changes with the end of the way.
struct WayImpulse {
    double impulse = 0;  ///< along the normal [N s], never negative
    double slope = 0;    ///< d impulse / d depth_t1 [N s/m], never positive: who ends deeper is pushed harder
};

/// Continuous penalty impulse with a weight over the step: -k dt times the
/// integral of weight(tau) min(0, depth(tau)).
///
/// The weight is a power of tau with the mean 1 and its centre at `centre`, so that for a way
/// that lies inside altogether the impulse is -k dt times the depth at tau = centre. 1/2 is
/// chapter 1's continuous impulse, where every moment counts the same; 1 its discrete one,
/// where only the end does; 2/3 a weight that grows as tau does.
///
/// @param depth_t0, depth_t1  signed depth at both ends of the step [m], negative inside, linear in between
/// @param centre              of the weight, above 0 and at most 1
/// @param k                   penalty stiffness [N/m], positive
/// @param dt                  length of the step [s], positive
WayImpulse weighted_impulse(double depth_t0, double depth_t1, double centre, double k, double dt);

}  // namespace enduring
