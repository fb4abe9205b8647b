#pragma once

#include "common/geometry/vector.hpp"

#include <optional>

namespace enduring {

/// The times from `first` to `last`; none if `first` is the larger one.
struct Times {
    double first = 0, last = 1;
    bool empty() const { return first > last; }
};

/// Those of some times at which low <= at_start + tau * rate <= high.
/// @return  may be empty; stays empty if it was
Times when_between(const Times& times, double at_start, double rate, double low, double high);

/// First time at which an edge that glides meets an edge that rests. Both are closed and have a length.
/// @param a0, a1  where the gliding edge is at tau = 0 [m]
/// @param way     by which both its ends have moved at tau = 1 [m]
/// @param b0, b1  the resting edge [m]
/// @return        tau in [0, 1], or nothing
std::optional<double> first_touch_of_gliding_edge(const Vec3& a0, const Vec3& a1, const Vec3& way,
                                                  const Vec3& b0, const Vec3& b1);

}  // namespace enduring
