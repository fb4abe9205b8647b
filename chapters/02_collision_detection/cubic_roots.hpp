#pragma once

#include <array>
#include <cstddef>

namespace enduring {

/// Up to three numbers in ascending order, read as a range.
struct RealRoots {
    std::array<double, 3> values{};
    std::size_t count = 0;

    const double* begin() const { return values.data(); }
    const double* end() const { return values.data() + count; }
};

/// Real roots of c[0] + c[1] t + c[2] t^2 + c[3] t^3 by the textbook's closed form: Cardano's, with cosines
/// where there are three. A leading coefficient of at most `zero` times the largest one is dropped, and with
/// it the degree; the zero polynomial has no roots here, although every t is one.
RealRoots cubic_roots(const std::array<double, 4>& c, double zero);

}  // namespace enduring
