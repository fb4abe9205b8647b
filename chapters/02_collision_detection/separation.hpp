#pragma once

#include "chapters/02_collision_detection/bounded_polynomial.hpp"

#include <algorithm>

namespace enduring::certified {

/// A vector of either number type.
template <class Real>
struct Triple {
    Real x, y, z;
};

template <class Real>
Triple<Real> operator+(const Triple<Real>& a, const Triple<Real>& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class Real>
Triple<Real> operator*(const Real& s, const Triple<Real>& a)
{
    return {s * a.x, s * a.y, s * a.z};
}

template <class Real>
Triple<Real> half(const Triple<Real>& a)
{
    return {half(a.x), half(a.y), half(a.z)};
}

template <class Real>
Triple<Real> cross(const Triple<Real>& a, const Triple<Real>& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Real>
Real dot(const Triple<Real>& a, const Triple<Real>& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Real>
double largest(const Triple<Real>& a)
{
    return std::max({std::abs(rounded(a.x)), std::abs(rounded(a.y)), std::abs(rounded(a.z))});
}

/// A vector that is a polynomial in time, in Bernstein form; no component is
/// larger than `size` or off by more than `error`.
template <class Real, std::size_t Degree>
struct MovingVector {
    using Component = Real Triple<Real>::*;
    std::array<Triple<Real>, Degree + 1> c;
    double size, error;

    BoundedPolynomial<Real, Degree> component(Component axis) const
    {
        BoundedPolynomial<Real, Degree> result;
        for (std::size_t i = 0; i <= Degree; ++i)
            result.c[i] = c[i].*axis;
        result.error = error;
        return result;
    }
};

/// No component of any value is larger.
template <class Real, std::size_t Degree>
double largest(const MovingVector<Real, Degree>& vector)
{
    double size = 0;
    for (const Triple<Real>& c : vector.c)
        size = std::max(size, largest(c));
    return room * size + vector.error;
}

/// The difference of two points that move on straight lines.
template <class Real>
using MovingDifference = MovingVector<Real, 1>;

// Error bounds, to first order in u, the cost of one rounding; the constants are larger
// than needed by enough to cover the rest. A and B are the sizes of two differences a
// and b, off by at most u of themselves in each component.
//   a x b        10 u AB: each of 4 products 3u, each of 3 sums u of what it adds; the result is at most 2AB
//   a . (b x c)  76 u ABC: 3 products, each 10u from the cross product and 4u more, and the sums; at most 6ABC
constexpr double cross_error = 12, triple_error = 80;

//! [cross]
/// The cross product of two moving differences: quadratic in time.
template <class Real>
MovingVector<Real, 2> cross(const MovingDifference<Real>& a, const MovingDifference<Real>& b)
{
    const double size = a.size * b.size;
    return {
        {cross(a.c[0], b.c[0]), half(cross(a.c[0], b.c[1]) + cross(a.c[1], b.c[0])), cross(a.c[1], b.c[1])},
        2 * size,
        cross_error * Precision<Real>::unit * size + underflow};
}
//! [cross]

/// 1/3 in either number type.
template <class Real>
constexpr Real third = 1.0 / 3.0;
template <>
inline constexpr DoubleDouble third<DoubleDouble>{1.0 / 3.0, 0x1.5555555555555p-56};

/// a(t) . n(t), cubic in time, where n is a cross product.
template <class Real>
BoundedPolynomial<Real, 3> dot(const MovingDifference<Real>& a, const MovingVector<Real, 2>& n)
{
    const Real start_middle = dot(a.c[0], n.c[1]), end_middle = dot(a.c[1], n.c[1]);
    return {{dot(a.c[0], n.c[0]), (dot(a.c[1], n.c[0]) + (start_middle + start_middle)) * third<Real>,
             (dot(a.c[0], n.c[2]) + (end_middle + end_middle)) * third<Real>, dot(a.c[1], n.c[2])},
            0.5 * triple_error * Precision<Real>::unit * (a.size * n.size) + underflow};
}

}  // namespace enduring::certified
