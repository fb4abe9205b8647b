#pragma once

#include "chapters/02_collision_detection/double_double.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace enduring::certified {

/// What one rounding costs in each number type.
template <class Real>
struct Precision;
template <>
struct Precision<double> {
    static constexpr double unit = 0x1p-53;
};
template <>
struct Precision<DoubleDouble> {
    static constexpr double unit = 0x1p-103;
};

/// A product that underflows loses at most 2^-1074; this covers all such losses of one query.
constexpr double underflow = 0x1p-1000;

/// A size read from the leading double of a double-double may be short of the true one by a rounding or two.
constexpr double room = 1 + 0x1p-50;

//! [bounded]
/// +1 or -1 if all numbers between `low` and `high`, each off by at most
/// `error`, certainly have that sign, else 0.
inline int certain_sign(double low, double high, double error)
{
    return low > error ? 1 : high < -error ? -1 : 0;
}

/// A polynomial on [0, 1] in Bernstein form, with a bound on how far each
/// computed coefficient may be from the true one.
///
/// Between its ends the polynomial is a weighted mean of the coefficients. So if all of them lie beyond the
/// error on one side of zero, the exact polynomial has that sign on the whole interval: one certain statement
/// about infinitely many instants, from Degree + 1 comparisons.
template <class Real, std::size_t Degree>
struct BoundedPolynomial {
    std::array<Real, Degree + 1> c;
    double error;

    /// No value is larger.
    double size() const
    {
        double largest = 0;
        for (const Real& value : c)
            largest = std::max(largest, std::abs(rounded(value)));
        return room * largest + error;
    }

    /// The certain sign of coefficient i, or 0.
    int sign(std::size_t i) const { return certain_sign(rounded(c[i]), rounded(c[i]), error); }

    /// The certain sign over the whole interval, or 0.
    int sign() const
    {
        double low = rounded(c[0]), high = low;
        for (std::size_t i = 1; i <= Degree; ++i) {
            low = std::min(low, rounded(c[i]));
            high = std::max(high, rounded(c[i]));
        }
        return certain_sign(low, high, error);
    }
};
//! [bounded]

/// The value at s by de Casteljau's rounds.
template <class Real, std::size_t Count>
Real value_at(std::array<Real, Count> c, const Real& s)
{
    const Real rest = Real(1.0) - s;
    for (std::size_t round = 1; round < Count; ++round)
        for (std::size_t i = 0; i + round < Count; ++i)
            c[i] = rest * c[i] + s * c[i + 1];
    return c[0];
}

/// What this costs: in each of `degree` rounds five roundings of the largest coefficient.
template <class Real>
constexpr double value_error(std::size_t degree, double size)
{
    return 5 * Precision<Real>::unit * static_cast<double>(degree) * size;
}

/// The polynomial from 0 to s.
template <std::size_t Degree>
BoundedPolynomial<double, Degree> up_to(const BoundedPolynomial<double, Degree>& f, double s)
{
    BoundedPolynomial<double, Degree> part = f;
    for (std::size_t round = 1; round <= Degree; ++round)
        for (std::size_t i = Degree; i >= round; --i)
            part.c[i] = (1 - s) * part.c[i - 1] + s * part.c[i];
    part.error += value_error<double>(Degree, f.size());
    return part;
}

}  // namespace enduring::certified
