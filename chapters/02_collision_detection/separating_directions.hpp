#pragma once

#include "chapters/02_collision_detection/query.hpp"
#include "chapters/02_collision_detection/separation.hpp"

#include <span>

namespace enduring::certified {

/// The difference of two coordinates: rounded once in doubles, exact in double-doubles.
template <class Real>
Real difference(double a, double b);
template <>
inline double difference<double>(double a, double b)
{
    return a - b;
}
template <>
inline DoubleDouble difference<DoubleDouble>(double a, double b)
{
    return two_difference(a, b);
}

template <class Real>
MovingDifference<Real> difference(const Vec3& a_t0, const Vec3& b_t0, const Vec3& a_t1, const Vec3& b_t1)
{
    const auto minus = [](const Vec3& a, const Vec3& b) {
        return Triple<Real>{difference<Real>(a[0], b[0]), difference<Real>(a[1], b[1]),
                            difference<Real>(a[2], b[2])};
    };
    const Triple<Real> start = minus(a_t0, b_t0), end = minus(a_t1, b_t1);
    const double size = std::max(largest(start), largest(end));
    return {{start, end}, size, Precision<Real>::unit * size};
}

/// What the signs of several numbers say together.
struct Signs {
    bool some_negative = false, some_positive = false, all_negative = true, all_positive = true;

    void add(int sign)
    {
        some_negative |= (sign < 0);
        some_positive |= (sign > 0);
        all_negative &= (sign < 0);
        all_positive &= (sign > 0);
    }
    bool all_agree() const { return all_negative || all_positive; }
    bool some_disagree() const { return some_negative && some_positive; }
};

/// Of numbers that are known exactly.
template <std::size_t Count>
Signs signs_of(const std::array<double, Count>& values)
{
    Signs result;
    for (const double value : values)
        result.add(value > 0 ? 1 : value < 0 ? -1 : 0);
    return result;
}

/// Of one component of several vectors, each as far as it is certain.
template <class Vectors, class Axis>
Signs signs(const Vectors& vectors, Axis axis)
{
    Signs result;
    for (const auto& vector : vectors)
        result.add(vector.component(axis).sign());
    return result;
}

//! [polygons]
/// The polygon of differences between the points of one feature and those of another. The features touch
/// exactly when the origin lies in it. Its corners are the first of `v`; each side, and the height, is a
/// product of some of them.
///
/// A vertex in a face: the triangle of the differences v - f_i.
template <class Value>
struct VertexFaceDifferences {
    static constexpr std::size_t corners = 3;
    static constexpr std::array<std::array<std::size_t, 2>, corners> sides{{{1, 2}, {2, 0}, {0, 1}}};
    static constexpr std::array<std::size_t, 3> height{0, 1, 2};
    std::array<Value, 3> v;
};

/// Two edges: the parallelogram of the differences d_ij = ea_i - eb_j. Behind its corners d_00, d_01, d_10,
/// d_11 stand a = ea1 - ea0 and b = eb1 - eb0.
template <class Value>
struct EdgeEdgeDifferences {
    static constexpr std::size_t corners = 4;
    static constexpr std::array<std::array<std::size_t, 2>, corners> sides{{{5, 0}, {2, 5}, {4, 0}, {1, 4}}};
    static constexpr std::array<std::size_t, 3> height{4, 5, 0};
    std::array<Value, 6> v;
};

template <class Real>
VertexFaceDifferences<MovingDifference<Real>> differences(const VertexFaceStep& s)
{
    return {{difference<Real>(s.v_t0, s.f0_t0, s.v_t1, s.f0_t1),
             difference<Real>(s.v_t0, s.f1_t0, s.v_t1, s.f1_t1),
             difference<Real>(s.v_t0, s.f2_t0, s.v_t1, s.f2_t1)}};
}

template <class Real>
EdgeEdgeDifferences<MovingDifference<Real>> differences(const EdgeEdgeStep& s)
{
    return {{difference<Real>(s.ea0_t0, s.eb0_t0, s.ea0_t1, s.eb0_t1),
             difference<Real>(s.ea0_t0, s.eb1_t0, s.ea0_t1, s.eb1_t1),
             difference<Real>(s.ea1_t0, s.eb0_t0, s.ea1_t1, s.eb0_t1),
             difference<Real>(s.ea1_t0, s.eb1_t0, s.ea1_t1, s.eb1_t1),
             difference<Real>(s.ea1_t0, s.ea0_t0, s.ea1_t1, s.ea0_t1),
             difference<Real>(s.eb1_t0, s.eb0_t0, s.eb1_t1, s.eb0_t1)}};
}

/// The height of the origin over the polygon, times its area: cubic in time, or a number at one instant.
template <class Polygon>
auto height(const Polygon& p)
{
    return dot(p.v[Polygon::height[0]], cross(p.v[Polygon::height[1]], p.v[Polygon::height[2]]));
}

template <class Polygon>
auto side(const Polygon& p, std::size_t i)
{
    return cross(p.v[Polygon::sides[i][0]], p.v[Polygon::sides[i][1]]);
}
//! [polygons]

/// The largest of its differences.
template <class Polygon>
double size(const Polygon& p)
{
    double largest = 0;
    for (const auto& v : p.v)
        largest = std::max(largest, v.size);
    return largest;
}

/// Whether the boxes of the two features are certainly apart throughout the step: along an axis all corners
/// have one sign.
template <class Polygon>
bool boxes_apart(const Polygon& p)
{
    const std::span corners(p.v.data(), Polygon::corners);
    return signs(corners, axes<double>[0]).all_agree() || signs(corners, axes<double>[1]).all_agree() ||
           signs(corners, axes<double>[2]).all_agree();
}

}  // namespace enduring::certified
