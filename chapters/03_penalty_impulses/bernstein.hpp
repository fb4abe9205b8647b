#pragma once

#include <array>

namespace enduring {

/// A part of the step, 0 <= from <= to <= 1.
struct Interval {
    double from = 0, to = 1;
    double length() const { return to - from; }
};

//! [bernstein]
/// A polynomial on [0, 1] in Bernstein form: sum_i coefficients[i] B_i^Degree(tau), thesis (5.11).
///
/// Three properties carry the chapter: the first and last coefficient are the values at 0 and 1, the value
/// anywhere is a weighted mean of the coefficients (so coefficients of one sign mean values of that sign),
/// and the integral over [0, 1] is their plain mean.
template <class Value, int Degree>
struct Bernstein {
    std::array<Value, Degree + 1> coefficients;

    /// De Casteljau's scheme.
    Value operator()(double tau) const { return from(tau).coefficients[0]; }

    /// The same polynomial with [tau, 1] as its new [0, 1]: neighbours mix, Degree times.
    Bernstein from(double tau) const
    {
        Bernstein rest = *this;
        auto& c = rest.coefficients;
        for (std::size_t round = 0; round < Degree; ++round)
            for (std::size_t i = 0; i < Degree - round; ++i)
                c[i] = (1 - tau) * c[i] + tau * c[i + 1];
        return rest;
    }

    /// The same polynomial with [0, tau] as its new [0, 1]: the same scheme, read from the other end.
    Bernstein until(double tau) const
    {
        Bernstein rest = *this;
        auto& c = rest.coefficients;
        for (std::size_t round = 0; round < Degree; ++round)
            for (std::size_t i = Degree; i > round; --i)
                c[i] = (1 - tau) * c[i - 1] + tau * c[i];
        return rest;
    }
};

/// The same polynomial with `part` as its new [0, 1].
template <class Value, int Degree>
Bernstein<Value, Degree> restricted(const Bernstein<Value, Degree>& polynomial, const Interval& part)
{
    const Bernstein<Value, Degree> rest = part.from > 0 ? polynomial.from(part.from) : polynomial;
    return part.to < 1 ? rest.until(part.length() / (1 - part.from)) : rest;
}
//! [bernstein]

/// d/dtau: one degree less, and differences of neighbours for coefficients.
template <class Value, int Degree>
Bernstein<Value, Degree - 1> derivative(const Bernstein<Value, Degree>& polynomial)
{
    Bernstein<Value, Degree - 1> result;
    for (std::size_t i = 0; i < Degree; ++i)
        result.coefficients[i] = Degree * (polynomial.coefficients[i + 1] - polynomial.coefficients[i]);
    return result;
}

}  // namespace enduring
