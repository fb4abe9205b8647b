#pragma once

#include "chapters/02_collision_detection/query.hpp"
#include "chapters/02_collision_detection/separation.hpp"

#include <tuple>

namespace enduring::certified {

/// The difference of two coordinates: rounded once in doubles, exact in double-doubles.
template <class Real> Real difference(double a, double b);
template <> inline double difference<double>(double a, double b) { return a - b; }
template <> inline DoubleDouble difference<DoubleDouble>(double a, double b) { return two_difference(a, b); }

template <class Real>
MovingDifference<Real> difference(const Vec3& a_t0, const Vec3& b_t0, const Vec3& a_t1, const Vec3& b_t1)
{
    const auto minus = [](const Vec3& a, const Vec3& b) {
        return Triple<Real>{difference<Real>(a[0], b[0]), difference<Real>(a[1], b[1]), difference<Real>(a[2], b[2])};
    };
    const Triple<Real> start = minus(a_t0, b_t0), end = minus(a_t1, b_t1);
    const double size = std::max(largest(start), largest(end));
    return {{start, end}, size, Precision<Real>::unit * size};
}

//! [polygons]
/// The triangle of differences v - f_i: the origin lies in it exactly when the vertex lies in the face.
template <class Real>
struct VertexFaceDifferences {
    static constexpr std::size_t corners = 3;
    MovingDifference<Real> d0, d1, d2;

    explicit VertexFaceDifferences(const VertexFaceStep& s)
        : d0(difference<Real>(s.v_t0, s.f0_t0, s.v_t1, s.f0_t1)),
          d1(difference<Real>(s.v_t0, s.f1_t0, s.v_t1, s.f1_t1)),
          d2(difference<Real>(s.v_t0, s.f2_t0, s.v_t1, s.f2_t1))
    {
    }
    double size() const { return std::max({d0.size, d1.size, d2.size}); }
};

/// The parallelogram of differences d_ij = ea_i - eb_j: the origin lies in it exactly when the edges meet.
template <class Real>
struct EdgeEdgeDifferences {
    static constexpr std::size_t corners = 4;
    MovingDifference<Real> a, b, d00, d01, d10, d11;  ///< its sides ea1 - ea0 and eb1 - eb0, and its corners

    explicit EdgeEdgeDifferences(const EdgeEdgeStep& s)
        : a(difference<Real>(s.ea1_t0, s.ea0_t0, s.ea1_t1, s.ea0_t1)),
          b(difference<Real>(s.eb1_t0, s.eb0_t0, s.eb1_t1, s.eb0_t1)),
          d00(difference<Real>(s.ea0_t0, s.eb0_t0, s.ea0_t1, s.eb0_t1)),
          d01(difference<Real>(s.ea0_t0, s.eb1_t0, s.ea0_t1, s.eb1_t1)),
          d10(difference<Real>(s.ea1_t0, s.eb0_t0, s.ea1_t1, s.eb0_t1)),
          d11(difference<Real>(s.ea1_t0, s.eb1_t0, s.ea1_t1, s.eb1_t1))
    {
    }
    double size() const { return std::max({d00.size, d01.size, d10.size, d11.size}); }
};
//! [polygons]

/// Signs of one component of several vectors over a whole interval, or at its start.
struct Signs {
    bool some_negative = false, some_positive = false, all_negative = true, all_positive = true;

    void add(int sign)
    {
        some_negative |= sign < 0, some_positive |= sign > 0;
        all_negative &= sign < 0, all_positive &= sign > 0;
    }
    bool all_agree() const { return all_negative || all_positive; }
    bool some_disagree() const { return some_negative && some_positive; }
};

//! [directions]
/// Polynomials of degree 1, 2 and 3 whose signs keep the origin out of a moving triangle or parallelogram.
///
/// The origin lies in the polygon at one instant if and only if
///   - `height`, the volume it spans with the polygon, is zero;
///   - no two `sides` point in opposite directions: with height zero all are multiples of one normal, and the multiples
///     are the weights of the contact point;
///   - no axis has all corners strictly on one side of it.
template <class Real, std::size_t Corners>
struct SeparatingDirections {
    template <std::size_t Degree> using Components = std::array<std::array<BoundedPolynomial<Real, Degree>, Corners>, 3>;
    BoundedPolynomial<Real, 3> height;
    Components<2> sides;
    Components<1> corners;

    /// Certainly no contact at any time of the interval.
    bool apart() const { return apart([](const auto& p) { return p.sign(); }); }

    /// Certainly no contact at the start of the interval.
    bool apart_at_start() const { return apart([](const auto& p) { return p.sign(0); }); }

    /// Certainly exactly one contact: the height changes sign once, within the polygon.
    bool crosses_once() const
    {
        const std::array<int, 4> s{height.sign(0), height.sign(1), height.sign(2), height.sign(3)};
        const bool one_change = s[0] * s[3] < 0 && s[1] * s[2] != 0 && (s[1] == s[0] || s[2] == s[3]);
        return one_change && std::any_of(sides.begin(), sides.end(), [](const auto& axis) {
            return signs(axis, [](const auto& p) { return p.sign(); }).all_agree();
        });
    }

private:
    template <class Sign>
    bool apart(const Sign& sign) const
    {
        if (sign(height) != 0)
            return true;
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (signs(sides[axis], sign).some_disagree() || signs(corners[axis], sign).all_agree())
                return true;
        return false;
    }

    template <class Polynomials, class Sign>
    static Signs signs(const Polynomials& polynomials, const Sign& sign)
    {
        Signs result;
        for (const auto& p : polynomials)
            result.add(sign(p));
        return result;
    }
};
//! [directions]

/// The polynomials of the three components of one vector, with room in their errors for `halvings` halvings.
template <class Real, std::size_t Degree, std::size_t Corners>
void set_components(std::array<std::array<BoundedPolynomial<Real, Degree>, Corners>, 3>& components, std::size_t corner,
                    const MovingVector<Real, Degree>& vector, int halvings)
{
    const double error = vector.error + halving_error<Real>(halvings, Degree, vector.size);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        auto& polynomial = components[axis][corner];
        polynomial.error = error;
        for (std::size_t i = 0; i <= Degree; ++i)
            polynomial.c[i] = vector.c[i][axis];
    }
}

template <class Real>
SeparatingDirections<Real, 3> separating_directions(const VertexFaceDifferences<Real>& d, int halvings)
{
    const auto side_0 = cross(d.d1, d.d2);
    SeparatingDirections<Real, 3> result;
    result.height = dot(d.d0, side_0);
    result.height.error += halving_error<Real>(halvings, 3, 3 * d.d0.size * side_0.size);
    set_components(result.sides, 0, side_0, halvings);
    set_components(result.sides, 1, cross(d.d2, d.d0), halvings);
    set_components(result.sides, 2, cross(d.d0, d.d1), halvings);
    set_components(result.corners, 0, d.d0, halvings);
    set_components(result.corners, 1, d.d1, halvings);
    set_components(result.corners, 2, d.d2, halvings);
    return result;
}

template <class Real>
SeparatingDirections<Real, 4> separating_directions(const EdgeEdgeDifferences<Real>& d, int halvings)
{
    const auto side_0 = cross(d.b, d.d00);
    SeparatingDirections<Real, 4> result;
    result.height = dot(d.a, side_0);
    result.height.error += halving_error<Real>(halvings, 3, 3 * d.a.size * side_0.size);
    set_components(result.sides, 0, side_0, halvings);
    set_components(result.sides, 1, cross(d.d10, d.b), halvings);
    set_components(result.sides, 2, cross(d.a, d.d00), halvings);
    set_components(result.sides, 3, cross(d.d01, d.a), halvings);
    set_components(result.corners, 0, d.d00, halvings);
    set_components(result.corners, 1, d.d01, halvings);
    set_components(result.corners, 2, d.d10, halvings);
    set_components(result.corners, 3, d.d11, halvings);
    return result;
}

/// The same tests over the earlier and the later half of the interval.
template <class Real, std::size_t Corners>
std::pair<SeparatingDirections<Real, Corners>, SeparatingDirections<Real, Corners>>
halves(const SeparatingDirections<Real, Corners>& whole)
{
    auto parts = std::make_pair(whole, whole);
    const auto split = [](auto& early, auto& late) { std::tie(early.c, late.c) = halves(early.c); };
    split(parts.first.height, parts.second.height);
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t corner = 0; corner < Corners; ++corner) {
            split(parts.first.sides[axis][corner], parts.second.sides[axis][corner]);
            split(parts.first.corners[axis][corner], parts.second.corners[axis][corner]);
        }
    return parts;
}

/// The same tests over the rest of the interval after s.
template <class Real, std::size_t Corners>
SeparatingDirections<Real, Corners> from(SeparatingDirections<Real, Corners> directions, double s)
{
    directions.height.c = from(directions.height.c, s);
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t corner = 0; corner < Corners; ++corner) {
            directions.sides[axis][corner].c = from(directions.sides[axis][corner].c, s);
            directions.corners[axis][corner].c = from(directions.corners[axis][corner].c, s);
        }
    return directions;
}

}  // namespace enduring::certified
