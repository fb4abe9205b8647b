#pragma once

#include "chapters/02_collision_detection/bounded_polynomial.hpp"

#include "common/geometry/vector.hpp"

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
Triple<Real> minus(const Triple<Real>& a)
{
    return {-a.x, -a.y, -a.z};
}

template <class Real>
Triple<Real> operator*(const Real& s, const Triple<Real>& a)
{
    return {s * a.x, s * a.y, s * a.z};
}

/// The components of a vector, to be gone through.
template <class Real>
inline constexpr std::array<Real Triple<Real>::*, 3> axes{&Triple<Real>::x, &Triple<Real>::y,
                                                          &Triple<Real>::z};

template <class Real>
Vec3 rounded(const Triple<Real>& a)
{
    return {rounded(a.x), rounded(a.y), rounded(a.z)};
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

// Error bounds, to first order in u, the cost of one rounding. A, B are the sizes of two differences and a, b
// their errors, u A and u B for those of coordinates.
//   at an instant   5 u A more: a difference of at most 2 A, its product, a sum
//   a x b           2 (a B + b A) + 6 u AB: half of four products, each with a B + b A + u AB,
//                   and of three sums
//   a . n           3 (a N + A n) + 20 u AN, for n of size N and error n: three products,
//                   and sums of at most 3 AN
// The second has 2 u AB more in the code, which covers what is of higher order, also in the third.
constexpr double instant_error = 5, cross_error = 8, height_error = 20;

/// Where the difference is at the instant t, a point on a straight line.
template <class Real>
MovingVector<Real, 0> at(const MovingDifference<Real>& d, const Real& t)
{
    if (rounded(t) == 0)
        return {{d.c[0]}, d.size, d.error};
    if (!(t < Real(1.0)))
        return {{d.c[1]}, d.size, d.error};
    return {{d.c[0] + t * (d.c[1] + minus(d.c[0]))},
            d.size,
            d.error + instant_error * Precision<Real>::unit * d.size};
}

template <class Real>
MovingVector<Real, 0> end_of(const MovingDifference<Real>& d)
{
    return {{d.c[1]}, d.size, d.error};
}

/// The same motion over the part of the step from one instant to another.
template <class Real>
MovingDifference<Real> between(const MovingVector<Real, 0>& from, const MovingVector<Real, 0>& to)
{
    return {{from.c[0], to.c[0]}, std::max(from.size, to.size), std::max(from.error, to.error)};
}

template <class Real, std::size_t Degree>
double cross_bound(const MovingVector<Real, Degree>& a, const MovingVector<Real, Degree>& b)
{
    return 2 * (a.error * b.size + b.error * a.size) +
           cross_error * Precision<Real>::unit * (a.size * b.size) + underflow;
}

//! [cross]
/// The cross product of two moving differences: quadratic in time.
template <class Real>
MovingVector<Real, 2> cross(const MovingDifference<Real>& a, const MovingDifference<Real>& b)
{
    return {
        {cross(a.c[0], b.c[0]), half(cross(a.c[0], b.c[1]) + cross(a.c[1], b.c[0])), cross(a.c[1], b.c[1])},
        2 * a.size * b.size,
        cross_bound(a, b)};
}
//! [cross]

/// The cross product at one instant.
template <class Real>
MovingVector<Real, 0> cross(const MovingVector<Real, 0>& a, const MovingVector<Real, 0>& b)
{
    return {{cross(a.c[0], b.c[0])}, 2 * a.size * b.size, cross_bound(a, b)};
}

/// 1/3 in either number type.
template <class Real>
constexpr Real third = 1.0 / 3.0;
template <>
inline constexpr DoubleDouble third<DoubleDouble>{1.0 / 3.0, 0x1.5555555555555p-56};

template <class Real, std::size_t A, std::size_t N>
double height_bound(const MovingVector<Real, A>& a, const MovingVector<Real, N>& n)
{
    return 3 * (a.error * n.size + a.size * n.error) +
           height_error * Precision<Real>::unit * (a.size * n.size) + underflow;
}

/// a(t) . n(t), cubic in time, where n is a cross product.
template <class Real>
BoundedPolynomial<Real, 3> dot(const MovingDifference<Real>& a, const MovingVector<Real, 2>& n)
{
    const Real start_middle = dot(a.c[0], n.c[1]), end_middle = dot(a.c[1], n.c[1]);
    return {{dot(a.c[0], n.c[0]), (dot(a.c[1], n.c[0]) + (start_middle + start_middle)) * third<Real>,
             (dot(a.c[0], n.c[2]) + (end_middle + end_middle)) * third<Real>, dot(a.c[1], n.c[2])},
            height_bound(a, n)};
}

/// The same at one instant.
template <class Real>
BoundedPolynomial<Real, 0> dot(const MovingVector<Real, 0>& a, const MovingVector<Real, 0>& n)
{
    return {{dot(a.c[0], n.c[0])}, height_bound(a, n)};
}

}  // namespace enduring::certified
