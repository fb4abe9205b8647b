#pragma once

#include "chapters/02_collision_detection/double_double.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace enduring::certified {

/// What one rounding costs in each number type, how deep the search may
/// halve the step with it, and its steps in all.
template <class Real>
struct Precision;
template <>
struct Precision<double> {
    static constexpr double unit = 0x1p-53;
    static constexpr int deepest = 12, budget = 32;
};
template <>
struct Precision<DoubleDouble> {
    static constexpr double unit = 0x1p-103;
    static constexpr int deepest = 64, budget = 128;
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

/// de Casteljau at 1/2: the coefficients of the same polynomial over [0,
/// 1/2] and over [1/2, 1], each a new [0, 1].
template <class Value, std::size_t Count>
void halve(const std::array<Value, Count>& whole, std::array<Value, Count>& early,
           std::array<Value, Count>& late)
{
    late = whole;
    early[0] = whole[0];
    for (std::size_t round = 1; round < Count; ++round) {
        for (std::size_t i = 0; i + round < Count; ++i)
            late[i] = half(late[i] + late[i + 1]);
        early[round] = late[0];
    }
}

/// de Casteljau with a parameter of its own in each round. With all of them equal, the value there.
template <class Real, class Value, std::size_t Count>
Value blossom(std::array<Value, Count> c, const std::array<double, Count - 1>& parameters)
{
    for (std::size_t round = 1; round < Count; ++round) {
        const Real towards_end(parameters[round - 1]), towards_start = Real(1.0) - towards_end;
        for (std::size_t i = 0; i + round < Count; ++i)
            c[i] = towards_start * c[i] + towards_end * c[i + 1];
    }
    return c[0];
}

template <class Real, class Value, std::size_t Count>
Value value_at(const std::array<Value, Count>& c, double s)
{
    std::array<double, Count - 1> parameters;
    parameters.fill(s);
    return blossom<Real>(c, parameters);
}

/// The coefficients over [from, to], a part of [0, 1]: coefficient i is
/// the blossom of i times `to` and else `from`.
template <class Real, class Value, std::size_t Count>
std::array<Value, Count> part(const std::array<Value, Count>& c, double from, double to)
{
    std::array<double, Count - 1> parameters;
    parameters.fill(from);
    std::array<Value, Count> result;
    for (std::size_t i = 0; i < Count; ++i) {
        result[i] = blossom<Real>(c, parameters);
        if (i + 1 < Count)
            parameters[i] = to;
    }
    return result;
}

/// What these cost: in each of `degree` rounds one rounding of the largest
/// coefficient for a halving, five for a blossom.
template <class Real>
constexpr double halving_error(std::size_t degree, double size)
{
    return Precision<Real>::unit * static_cast<double>(degree) * size;
}
template <class Real>
constexpr double blossom_error(std::size_t degree, double size)
{
    return 5 * halving_error<Real>(degree, size);
}

}  // namespace enduring::certified
