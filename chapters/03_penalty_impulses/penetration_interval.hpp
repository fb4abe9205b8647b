#pragma once

#include "chapters/03_penalty_impulses/bernstein.hpp"

#include <array>

namespace enduring {

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
