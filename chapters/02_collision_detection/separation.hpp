#pragma once

#include "chapters/02_collision_detection/bounded_polynomial.hpp"
#include "chapters/02_collision_detection/query.hpp"

#include <algorithm>

namespace enduring::certified {

/// A vector of either number type.
template <class Real>
struct Triple {
    Real x, y, z;
};

template <class Real> Triple<Real> operator+(const Triple<Real>& a, const Triple<Real>& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class Real> Triple<Real> cross(const Triple<Real>& a, const Triple<Real>& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Real> Real dot(const Triple<Real>& a, const Triple<Real>& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// A difference of two points over the step: linear in time, so its ends are its Bernstein coefficients.
template <class Real>
struct MovingDifference {
    Triple<Real> start, end;
    double size;  ///< largest component at either end, and so at any time

    MovingDifference(const Triple<Real>& at_start, const Triple<Real>& at_end)
        : start(at_start), end(at_end), size(std::max(largest(at_start), largest(at_end)))
    {
    }

    static double largest(const Triple<Real>& a)
    {
        return std::max({std::abs(rounded(a.x)), std::abs(rounded(a.y)), std::abs(rounded(a.z))});
    }
};

/// The cross product of two moving differences: quadratic, with coefficients up to `size` in each component.
template <class Real>
struct MovingCross {
    Triple<Real> c0, c1, c2;
    double size;
};

template <class Real>
MovingCross<Real> cross(const MovingDifference<Real>& a, const MovingDifference<Real>& b)
{
    const Triple<Real> mixed = cross(a.start, b.end) + cross(a.end, b.start);
    return {cross(a.start, b.start), {half(mixed.x), half(mixed.y), half(mixed.z)}, cross(a.end, b.end),
            a.size * b.size};
}

// Error bounds. With u one rounding, A, B, C the largest components of three differences a, b, c (each off by u of
// itself), and terms of order u^2 covered by the surplus:
//   a x b          a component is at most 2AB and off by at most 10 u AB
//   a . b          at most 3AB, off by 17 u AB;              each halving adds  2 rounds x 3 u AB
//   a . (b x c)    at most 6ABC, off by 76 u ABC;            each halving adds  3 rounds x 6 u ABC
//   (a x b).(c x d) at most 12 ABCD, off by 200 u ABCD;      each halving adds  4 rounds x 12 u ABCD
// Cutting at a point other than 1/2 adds at most 5 roundings a round instead of one: five halvings' worth.
template <class Real> constexpr double dot_error(int halvings) { return (20 + 6 * halvings) * Precision<Real>::unit; }
template <class Real> constexpr double cubic_error(int halvings) { return (84 + 18 * halvings) * Precision<Real>::unit; }
template <class Real> constexpr double quartic_error(int halvings) { return (220 + 48 * halvings) * Precision<Real>::unit; }

/// a(t) . b(t)
template <class Real>
BoundedPolynomial<Real, 2> dot(const MovingDifference<Real>& a, const MovingDifference<Real>& b, int halvings)
{
    return {{dot(a.start, b.start), half(dot(a.start, b.end) + dot(a.end, b.start)), dot(a.end, b.end)},
            dot_error<Real>(halvings) * (a.size * b.size) + underflow};
}

/// 1/3 and 1/6 in either number type.
template <class Real> constexpr Real third();
template <> constexpr double third<double>() { return 1.0 / 3.0; }
template <> constexpr DoubleDouble third<DoubleDouble>() { return {1.0 / 3.0, 0x1.5555555555555p-56}; }

/// a(t) . n(t), where n is a cross product
template <class Real>
BoundedPolynomial<Real, 3> dot(const MovingDifference<Real>& a, const MovingCross<Real>& n, int halvings)
{
    const Real mid_start = dot(a.start, n.c1), mid_end = dot(a.end, n.c1);
    return {{dot(a.start, n.c0), (dot(a.end, n.c0) + (mid_start + mid_start)) * third<Real>(),
             (dot(a.start, n.c2) + (mid_end + mid_end)) * third<Real>(), dot(a.end, n.c2)},
            cubic_error<Real>(halvings) * (a.size * n.size) + underflow};
}

/// m(t) . n(t)
template <class Real>
BoundedPolynomial<Real, 4> dot(const MovingCross<Real>& m, const MovingCross<Real>& n, int halvings)
{
    const Real middle = dot(m.c1, n.c1), twice = middle + middle;
    return {{dot(m.c0, n.c0), half(dot(m.c0, n.c1) + dot(m.c1, n.c0)),
             half((dot(m.c0, n.c2) + dot(m.c2, n.c0) + (twice + twice)) * third<Real>()),
             half(dot(m.c1, n.c2) + dot(m.c2, n.c1)), dot(m.c2, n.c2)},
            quartic_error<Real>(halvings) * (m.size * n.size) + underflow};
}

}  // namespace enduring::certified
