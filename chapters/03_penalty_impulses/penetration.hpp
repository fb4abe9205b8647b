#pragma once

#include "chapters/03_penalty_impulses/bernstein.hpp"
#include "common/simulation/normal_law.hpp"

#include <array>

namespace enduring {

//! [contact_normal]
/// The unnormalised contact normal over the step [m^2]: n0, n1, n2 of thesis (5.12) and (5.18).
///
/// A product of two straight motions is quadratic, so nothing is lost.
inline Bernstein<Vec3, 2> contact_normal(const PairStep& step)
{
    const Vec3 n0 = step.t0.side_1.cross(step.t0.side_2);
    const Vec3 n2 = step.t1.side_1.cross(step.t1.side_2);
    const Vec3 turn = (step.t1.side_1 - step.t0.side_1).cross(step.t1.side_2 - step.t0.side_2);
    return {{n0, 0.5 * (n0 + n2 - turn), n2}};
}

/// The penetration depth times the normal's length over the step [m^3]: n(tau) . (p -
/// q)(tau), thesis (5.6); negative inside. Quadratic times linear: a cubic, the same one
/// whose roots are the times of coplanarity in chapter 2.
inline Bernstein<double, 3> penetration_depth(const Bernstein<Vec3, 2>& normal, const PairStep& step)
{
    const auto& [n0, n1, n2] = normal.coefficients;
    const Vec3 &d0 = step.t0.offset, &d1 = step.t1.offset;
    return {{n0.dot(d0), (2 * n1.dot(d0) + n0.dot(d1)) / 3, (n2.dot(d0) + 2 * n1.dot(d1)) / 3, n2.dot(d1)}};
}
//! [contact_normal]

//! [squared_length]
/// The squared length of the normal over the step [m^4]: the L_i of thesis
/// (5.13), corrected to a sum (see the errata).
inline Bernstein<double, 4> squared_length(const Bernstein<Vec3, 2>& normal)
{
    const auto& [n0, n1, n2] = normal.coefficients;
    return {{n0.dot(n0), n0.dot(n1), (2 * n1.dot(n1) + n0.dot(n2)) / 3, n1.dot(n2), n2.dot(n2)}};
}

/// L_k^2, thesis (5.14): the mean of the L_i, which is the mean of the squared length over the step [m^4].
inline double mean_squared_length(const Bernstein<Vec3, 2>& normal)
{
    const auto [L0, L1, L2, L3, L4] = squared_length(normal).coefficients;
    return (L0 + L1 + L2 + L3 + L4) / 5;
}
//! [squared_length]

/// The parts of a step in which a depth is negative: none, one or two.
class PenetrationIntervals {
public:
    void add(const Interval& interval) { intervals_[count_++] = interval; }
    int size() const { return count_; }
    const Interval& operator[](int i) const { return intervals_[i]; }
    const Interval* begin() const { return intervals_.data(); }
    const Interval* end() const { return begin() + count_; }

private:
    std::array<Interval, 2> intervals_;
    int count_ = 0;
};

/// Where a depth that changes sign is negative, by its roots. See penetration_intervals.
PenetrationIntervals intervals_between_roots(const Bernstein<double, 3>& depth, double start);

//! [penetration_intervals]
/// Where a cubic depth is negative (thesis 5.2.1: [t_a, t_b], up to two of them).
///
/// @param depth  on [0, 1], finite
/// @param start  from where the pair counts, in [0, 1]: its time of impact, or 0 when it endures
/// @return       disjoint intervals in [start, 1], ascending
inline PenetrationIntervals penetration_intervals(const Bernstein<double, 3>& depth, double start = 0)
{
    // Values are weighted means of the coefficients: those of one sign answer without a root.
    const auto& [d0, d1, d2, d3] = depth.coefficients;
    PenetrationIntervals result;
    if (d0 >= 0 && d1 >= 0 && d2 >= 0 && d3 >= 0)
        return result;
    if (d0 > 0 || d1 > 0 || d2 > 0 || d3 > 0)
        return intervals_between_roots(depth, start);
    result.add({start, 1});
    return result;
}
//! [penetration_intervals]

}  // namespace enduring
