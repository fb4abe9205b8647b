#pragma once

#include "chapters/02_collision_detection/query.hpp"
#include "chapters/02_collision_detection/separation.hpp"

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

//! [polygons]
/// The triangle of differences v - f_i: the origin lies in it exactly when the vertex lies in the face.
template <class Real>
struct VertexFaceDifferences {
    MovingDifference<Real> d0, d1, d2;

    explicit VertexFaceDifferences(const VertexFaceStep& s)
        : d0(difference<Real>(s.v_t0, s.f0_t0, s.v_t1, s.f0_t1)),
          d1(difference<Real>(s.v_t0, s.f1_t0, s.v_t1, s.f1_t1)),
          d2(difference<Real>(s.v_t0, s.f2_t0, s.v_t1, s.f2_t1))
    {}
    double size() const { return std::max({d0.size, d1.size, d2.size}); }
};

/// The parallelogram of differences d_ij = ea_i - eb_j: the origin lies in it exactly when the edges meet.
template <class Real>
struct EdgeEdgeDifferences {
    const EdgeEdgeStep& step;
    MovingDifference<Real> a, b, d00;  ///< its sides ea1 - ea0 and eb1 - eb0, and a corner

    explicit EdgeEdgeDifferences(const EdgeEdgeStep& s)
        : step(s), a(difference<Real>(s.ea1_t0, s.ea0_t0, s.ea1_t1, s.ea0_t1)),
          b(difference<Real>(s.eb1_t0, s.eb0_t0, s.eb1_t1, s.eb0_t1)),
          d00(difference<Real>(s.ea0_t0, s.eb0_t0, s.ea0_t1, s.eb0_t1))
    {}
    double size() const { return std::max({a.size, b.size, d00.size}); }
};
//! [polygons]

/// What the signs of one component of several vectors say together.
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

/// Whether a sign is to hold over the whole interval, or at its start.
struct Throughout {
    template <class Polynomial>
    int operator()(const Polynomial& p) const
    {
        return p.sign();
    }
};
struct AtStart {
    template <class Polynomial>
    int operator()(const Polynomial& p) const
    {
        return p.sign(0);
    }
};

template <class Vectors, class Axis, class When>
Signs signs(const Vectors& vectors, Axis axis, const When& sign)
{
    Signs result;
    for (const auto& vector : vectors)
        result.add(sign(vector.component(axis)));
    return result;
}

//! [directions]
/// Polynomials of degree 1, 2 and 3 whose signs keep the origin out of a moving triangle or parallelogram.
///
/// The origin lies in the polygon at one instant if and only if
///   - `height`, the volume it spans with the polygon, is zero;
///   - no two `sides` point in opposite directions: with height zero all are
///     multiples of one normal, and the multiples
///     are the weights of the contact point;
///   - no axis has all corners strictly on one side of it.
template <class Real, std::size_t Corners>
struct SeparatingDirections {
    BoundedPolynomial<Real, 3> height;
    std::array<MovingVector<Real, 2>, Corners> sides;
    std::array<MovingVector<Real, 1>, Corners> corners;

    /// Certainly no contact at any time of the interval (Throughout), or at its start (AtStart).
    template <class When>
    bool apart(const When& when) const
    {
        return when(height) != 0 || apart_along(&Triple<Real>::x, when) ||
               apart_along(&Triple<Real>::y, when) || apart_along(&Triple<Real>::z, when);
    }

    /// Certainly the height vanishes exactly once in the interval, changing sign.
    bool height_changes_once() const
    {
        const std::array<int, 4> s{height.sign(0), height.sign(1), height.sign(2), height.sign(3)};
        return s[0] * s[3] < 0 && s[1] * s[2] != 0 && (s[1] == s[0] || s[2] == s[3]);
    }

    /// Where the height vanishes only between `time` and `time + width`, does it happen within the polygon?
    /// @return +1 certainly, -1 certainly not, 0 too close to call
    int within_polygon(double time, double width) const
    {
        std::array<MovingVector<Real, 0>, Corners> there;
        for (std::size_t i = 0; i < Corners; ++i) {
            const auto& side = sides[i];
            // A quadratic changes at most by 4 sizes over the whole interval.
            there[i] = {{value_at<Real>(side.c, time)},
                        side.size,
                        side.error + blossom_error<Real>(2, side.size) + 4 * width * side.size};
        }
        const std::array<Signs, 3> axes{signs(there, &Triple<Real>::x, Throughout{}),
                                        signs(there, &Triple<Real>::y, Throughout{}),
                                        signs(there, &Triple<Real>::z, Throughout{})};
        if (axes[0].some_disagree() || axes[1].some_disagree() || axes[2].some_disagree())
            return -1;
        return axes[0].all_agree() || axes[1].all_agree() || axes[2].all_agree() ? 1 : 0;
    }

private:
    template <class When>
    bool apart_along(Real Triple<Real>::*axis, const When& when) const
    {
        return signs(sides, axis, when).some_disagree() || signs(corners, axis, when).all_agree();
    }
};
//! [directions]

template <class Real>
BoundedPolynomial<Real, 3> height(const VertexFaceDifferences<Real>& d)
{
    return dot(d.d0, cross(d.d1, d.d2));
}

template <class Real>
BoundedPolynomial<Real, 3> height(const EdgeEdgeDifferences<Real>& d)
{
    return dot(d.a, cross(d.b, d.d00));
}

template <class Real>
SeparatingDirections<Real, 3> separating_directions(const VertexFaceDifferences<Real>& d)
{
    return {height(d), {cross(d.d1, d.d2), cross(d.d2, d.d0), cross(d.d0, d.d1)}, {d.d0, d.d1, d.d2}};
}

template <class Real>
SeparatingDirections<Real, 4> separating_directions(const EdgeEdgeDifferences<Real>& d)
{
    const EdgeEdgeStep& s = d.step;
    const auto d01 = difference<Real>(s.ea0_t0, s.eb1_t0, s.ea0_t1, s.eb1_t1),
               d10 = difference<Real>(s.ea1_t0, s.eb0_t0, s.ea1_t1, s.eb0_t1),
               d11 = difference<Real>(s.ea1_t0, s.eb1_t0, s.ea1_t1, s.eb1_t1);
    return {height(d),
            {cross(d.b, d.d00), cross(d10, d.b), cross(d.a, d.d00), cross(d01, d.a)},
            {d.d00, d01, d10, d11}};
}

/// The same polynomial, known a little less well, over each half of the interval.
template <class Real, std::size_t Degree>
void halve(const BoundedPolynomial<Real, Degree>& whole, BoundedPolynomial<Real, Degree>& early,
           BoundedPolynomial<Real, Degree>& late)
{
    halve(whole.c, early.c, late.c);
    early.error = late.error = whole.error + halving_error<Real>(Degree, whole.size());
}

template <class Real, std::size_t Degree>
void halve(const MovingVector<Real, Degree>& whole, MovingVector<Real, Degree>& early,
           MovingVector<Real, Degree>& late)
{
    halve(whole.c, early.c, late.c);
    early.error = late.error = whole.error + halving_error<Real>(Degree, whole.size);
    early.size = largest(early);
    late.size = largest(late);
}

/// The same tests over the earlier and the later half of the interval.
template <class Real, std::size_t Corners>
void halve(const SeparatingDirections<Real, Corners>& whole, SeparatingDirections<Real, Corners>& early,
           SeparatingDirections<Real, Corners>& late)
{
    halve(whole.height, early.height, late.height);
    for (std::size_t i = 0; i < Corners; ++i) {
        halve(whole.sides[i], early.sides[i], late.sides[i]);
        halve(whole.corners[i], early.corners[i], late.corners[i]);
    }
}

template <class Real, std::size_t Degree>
MovingVector<Real, Degree> part(const MovingVector<Real, Degree>& whole, double from, double to)
{
    MovingVector<Real, Degree> result{part<Real>(whole.c, from, to), 0,
                                      whole.error + blossom_error<Real>(Degree, whole.size)};
    result.size = largest(result);
    return result;
}

/// The same tests over a part of the interval.
template <class Real, std::size_t Corners>
SeparatingDirections<Real, Corners> part(const SeparatingDirections<Real, Corners>& whole, double from,
                                         double to)
{
    SeparatingDirections<Real, Corners> result;
    result.height.c = part<Real>(whole.height.c, from, to);
    result.height.error = whole.height.error + blossom_error<Real>(3, whole.height.size());
    for (std::size_t i = 0; i < Corners; ++i) {
        result.sides[i] = part(whole.sides[i], from, to);
        result.corners[i] = part(whole.corners[i], from, to);
    }
    return result;
}

}  // namespace enduring::certified
