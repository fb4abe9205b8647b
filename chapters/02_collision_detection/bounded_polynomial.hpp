#pragma once

#include "chapters/02_collision_detection/double_double.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace enduring::certified {

/// What one rounding costs in each number type, and how often the search may halve the step with it.
template <class Real> struct Precision;
template <> struct Precision<double> {
    static constexpr double unit = 0x1p-53;
    static constexpr int deepest = 12;
};
template <> struct Precision<DoubleDouble> {
    static constexpr double unit = 0x1p-103;
    static constexpr int deepest = 110;
};

/// Products of coordinates that underflow lose at most 2^-1074 each; this covers every such loss in one query.
constexpr double underflow = 0x1p-1000;

//! [bounded]
/// A polynomial on [0, 1] in Bernstein form, with a bound on how far each computed coefficient may be from the true one.
///
/// Between its ends the polynomial is a weighted mean of the coefficients. So if all of them lie beyond the error on one
/// side of zero, the exact polynomial has that sign on the whole interval: one certain statement about infinitely many
/// instants, from Degree + 1 comparisons.
template <class Real, std::size_t Degree>
struct BoundedPolynomial {
    std::array<Real, Degree + 1> c;
    double error = 0;

    /// The sign of coefficient i: +1 or -1 if it is certain, else 0.
    int sign(std::size_t i) const
    {
        const double value = rounded(c[i]);
        return value > error ? 1 : value < -error ? -1 : 0;
    }

    /// The certain sign over the whole interval, or 0.
    int sign() const
    {
        const int first = sign(0);
        for (std::size_t i = 1; i <= Degree; ++i)
            if (sign(i) != first)
                return 0;
        return first;
    }
};
//! [bounded]

/// de Casteljau at 1/2: the same polynomial over [0, 1/2] and over [1/2, 1], each with a new [0, 1].
template <class Real, std::size_t Degree>
std::pair<BoundedPolynomial<Real, Degree>, BoundedPolynomial<Real, Degree>>
halves(const BoundedPolynomial<Real, Degree>& whole)
{
    auto left = whole, right = whole;
    for (std::size_t round = 1; round <= Degree; ++round) {
        for (std::size_t i = 0; i + round <= Degree; ++i)
            right.c[i] = half(right.c[i] + right.c[i + 1]);
        left.c[round] = right.c[0];
    }
    return {left, right};
}

/// de Casteljau at any s in [0, 1]: the polynomial over [s, 1], with a new [0, 1]. Its first coefficient is the value
/// at s. Costs the accuracy of five halvings.
template <class Real, std::size_t Degree>
BoundedPolynomial<Real, Degree> from(const BoundedPolynomial<Real, Degree>& whole, double s)
{
    auto rest = whole;
    const Real towards_end(s), towards_start = Real(1.0) - Real(s);
    for (std::size_t round = 1; round <= Degree; ++round)
        for (std::size_t i = 0; i + round <= Degree; ++i)
            rest.c[i] = towards_start * rest.c[i] + towards_end * rest.c[i + 1];
    return rest;
}

}  // namespace enduring::certified
