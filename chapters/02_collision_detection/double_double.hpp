#pragma once

#include <cmath>

namespace enduring::certified {

/// A number of about 106 bits, kept as the unevaluated sum of two
/// doubles: hi is the sum rounded, lo what is left.
///
/// Every operation below has a relative error under 5 * 2^-106 as long as nothing overflows and no product
/// falls under 2^-960 (Joldes, Muller, Popescu 2017: "Tight and rigorous error bounds for basic building
/// blocks of double-word arithmetic", algorithms 6 and 10; products of doubles split as by Dekker 1971, so no
/// fused multiply-add is needed).
struct DoubleDouble {
    double hi = 0, lo = 0;

    constexpr DoubleDouble() = default;
    constexpr DoubleDouble(double value) : hi(value) {}
    constexpr DoubleDouble(double high, double low) : hi(high), lo(low) {}
};

/// a + b exactly, if |a| >= |b| or a is 0.
inline DoubleDouble fast_two_sum(double a, double b)
{
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

/// a + b exactly.
inline DoubleDouble two_sum(double a, double b)
{
    const double sum = a + b;
    const double b_part = sum - a;
    return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// a - b exactly: how a difference of two coordinates enters without any error.
inline DoubleDouble two_difference(double a, double b) { return two_sum(a, -b); }

/// a * b exactly.
inline DoubleDouble two_product(double a, double b)
{
    constexpr double splitter = 134217729;  // 2^27 + 1: cuts 53 bits into two halves of 26
    const double a_shifted = splitter * a, b_shifted = splitter * b;
    const double a_high = a_shifted - (a_shifted - a), b_high = b_shifted - (b_shifted - b);
    const double a_low = a - a_high, b_low = b - b_high;
    const double product = a * b;
    return {product, a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low)};
}

inline DoubleDouble operator-(DoubleDouble a) { return {-a.hi, -a.lo}; }

inline DoubleDouble operator+(DoubleDouble a, DoubleDouble b)
{
    const DoubleDouble high = two_sum(a.hi, b.hi);
    const DoubleDouble low = two_sum(a.lo, b.lo);
    const DoubleDouble sum = fast_two_sum(high.hi, high.lo + low.hi);
    return fast_two_sum(sum.hi, sum.lo + low.lo);
}

inline DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + -b; }

inline DoubleDouble operator*(DoubleDouble a, DoubleDouble b)
{
    const DoubleDouble product = two_product(a.hi, b.hi);
    return fast_two_sum(product.hi, product.lo + (a.hi * b.lo + a.lo * b.hi));
}

inline bool operator<(DoubleDouble a, DoubleDouble b) { return a.hi < b.hi || (a.hi == b.hi && a.lo < b.lo); }
inline bool operator>(DoubleDouble a, DoubleDouble b) { return b < a; }

/// The nearest double; the same name works for both number types.
inline double rounded(DoubleDouble a) { return a.hi; }
inline double rounded(double a) { return a; }

/// Exact division by two.
inline DoubleDouble half(DoubleDouble a) { return {0.5 * a.hi, 0.5 * a.lo}; }
inline double half(double a) { return 0.5 * a; }

}  // namespace enduring::certified
