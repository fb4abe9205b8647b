#pragma once

#include "contact_normal.hpp"
#include "penetration_interval.hpp"

namespace enduring {

/// Discrete penalty impulse of one pair over one step: the force of the step's end, for the whole step.
///
/// @param end  the pair at the end of the step
/// @param k    penalty stiffness of the pair [N/m], positive
/// @param dt   length of the step [s], positive
/// @return     impulse on p [N s]: vertex i receives its weight times it; zero outside, and for sides without a normal
/// @see thesis (5.5), with the normal at the end of the step and the weights of first contact, as its section 7 compares
// [discrete_impulse]
inline Vec3 discrete_impulse(const PairInstant& end, double k, double dt)
{
    const Vec3 normal = end.side_1.cross(end.side_2);
    const double depth = normal.dot(end.offset), squared_length = normal.squaredNorm();
    if (depth >= 0 || squared_length == 0)
        return Vec3::Zero();
    return (-k * dt * depth / squared_length) * normal;
}
// [discrete_impulse]

/// Integral over [0, 1] of depth(tau) normal(tau), in closed form: the product of a cubic and a quadratic has six
/// Bernstein coefficients, and its integral is their mean.
// [integral_of_product]
inline Vec3 integral_of_product(const Bernstein<double, 3>& depth, const Bernstein<Vec3, 2>& normal)
{
    const auto& [d0, d1, d2, d3] = depth.coefficients;
    const auto& [n0, n1, n2] = normal.coefficients;
    return ((10 * d0 + 6 * d1 + 3 * d2 + d3) * n0
            + (4 * d0 + 6 * d1 + 6 * d2 + 4 * d3) * n1
            + (d0 + 3 * d1 + 6 * d2 + 10 * d3) * n2) / 60;
}
// [integral_of_product]

/// Continuous penalty impulse of one pair over one step: the force -k delta(tau) n(tau), integrated over the part of the
/// step in which p lies behind q.
///
/// @param step   both ends of the step
/// @param start  from where the pair counts, in [0, 1]: its time of impact, or 0 when it endures
/// @param k      penalty stiffness of the pair [N/m], positive
/// @param dt     length of the step [s], positive
/// @return       impulse on p [N s]: vertex i receives its weight times it; zero for sides without a normal
/// @see thesis (5.8), (5.9) and (5.15) with the sign of (5.20) and the factor dt (errata); Tang et al. 2012, section 4
// [continuous_impulse]
inline Vec3 continuous_impulse(const PairStep& step, double start, double k, double dt)
{
    const Bernstein<Vec3, 2> normal = contact_normal(step);
    const Bernstein<double, 3> depth = penetration_depth(normal, step);

    Vec3 integral = Vec3::Zero();
    for (const Interval& inside : penetration_intervals(depth, start))
        integral += inside.length() * integral_of_product(restricted(depth, inside), restricted(normal, inside));

    // Depth and direction still carry the normal's length, each once: divide by L_k twice.
    const double squared_length = mean_squared_length(normal);
    return squared_length > 0 ? Vec3(-k * dt / squared_length * integral) : Vec3::Zero();
}
// [continuous_impulse]

}  // namespace enduring
