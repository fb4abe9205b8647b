#pragma once

#include "chapters/03_penalty_impulses/penetration.hpp"

namespace enduring {

/// Discrete penalty impulse of one pair over one step: the force of the step's end, for the whole step.
///
/// @param end  the pair at the end of the step
/// @param k    penalty stiffness of the pair [N/m], positive
/// @param dt   length of the step [s], positive
/// @return     impulse on p [N s]: vertex i receives its weight times it;
///     zero outside, and for sides without a normal
/// @see thesis (5.5), with the normal at the end of the step and the weights
///     of first contact, as its section 7 compares
Vec3 discrete_impulse(const PairInstant& end, double k, double dt);

/// Integral over [0, 1] of depth(tau) normal(tau), in closed form: the product of a cubic and a quadratic has
/// six Bernstein coefficients, and its integral is their mean.
Vec3 integral_of_product(const Bernstein<double, 3>& depth, const Bernstein<Vec3, 2>& normal);

/// Continuous penalty impulse of one pair over one step: the force -k delta(tau) n(tau), integrated over the
/// part of the step in which p lies behind q.
///
/// @param step   both ends of the step
/// @param start  from where the pair counts, in [0, 1]: its time of impact, or 0 when it endures
/// @param k      penalty stiffness of the pair [N/m], positive
/// @param dt     length of the step [s], positive
/// @return       impulse on p [N s]: vertex i receives its weight times it; zero for sides without a normal
/// @see thesis (5.8), (5.9) and (5.15) with the sign of (5.20) and the
///     factor dt (errata); Tang et al. 2012, section 4
Vec3 continuous_impulse(const PairStep& step, double start, double k, double dt);

}  // namespace enduring
