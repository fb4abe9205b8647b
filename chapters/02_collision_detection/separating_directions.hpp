#pragma once

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
    return {minus(a_t0, b_t0), minus(a_t1, b_t1)};
}

/// The corners of the triangle that the origin meets exactly when the vertex meets the face.
template <class Real>
struct VertexFaceDifferences {
    MovingDifference<Real> d0, d1, d2;  ///< v - f0, v - f1, v - f2

    explicit VertexFaceDifferences(const VertexFaceStep& s)
        : d0(difference<Real>(s.v_t0, s.f0_t0, s.v_t1, s.f0_t1)),
          d1(difference<Real>(s.v_t0, s.f1_t0, s.v_t1, s.f1_t1)),
          d2(difference<Real>(s.v_t0, s.f2_t0, s.v_t1, s.f2_t1))
    {
    }
    double size() const { return std::max({d0.size, d1.size, d2.size}); }
};

/// The corners and sides of the parallelogram that the origin meets exactly when the edges meet.
template <class Real>
struct EdgeEdgeDifferences {
    MovingDifference<Real> a, b;                ///< the edges: ea1 - ea0, eb1 - eb0
    MovingDifference<Real> d00, d01, d10, d11;  ///< dij = ea_i - eb_j

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

//! [directions]
/// Polynomials whose signs keep the origin out of a moving triangle (3 corners) or parallelogram (4 corners).
///
/// At one instant the origin lies in the polygon only if `height` is zero, no `agreement` is negative, and each corner
/// has an `alignment` that is not positive. The reverse holds too, so these tests overlook nothing.
template <class Real, std::size_t Corners>
struct SeparatingDirections {
    static constexpr std::size_t agreements = Corners == 3 ? 3 : 2, alignments = Corners * (Corners - 1) / 2;

    BoundedPolynomial<Real, 3> height;                              ///< of the polygon's plane over the origin
    std::array<BoundedPolynomial<Real, 4>, agreements> agreement;   ///< do the sides see the origin on the same hand?
    std::array<BoundedPolynomial<Real, 2>, alignments> alignment;   ///< d_i . d_j, for (0,1) (0,2) .. (1,2) ..

    /// Certainly no contact at any time of the interval.
    bool apart() const
    {
        if (height.sign() != 0)
            return true;
        for (const auto& q : agreement)
            if (q.sign() < 0)
                return true;
        return some_corner_faces_all([](const auto& p) { return p.sign(); });
    }

    /// Certainly no contact at the start of the interval.
    bool apart_at_start() const
    {
        if (height.sign(0) != 0)
            return true;
        for (const auto& q : agreement)
            if (q.sign(0) < 0)
                return true;
        return some_corner_faces_all([](const auto& p) { return p.sign(0); });
    }

    /// Certainly one crossing: the height changes sign once, inside the polygon.
    bool crosses_once() const
    {
        if (height.sign(0) * height.sign(3) >= 0)
            return false;
        if (height.sign(1) * height.sign(2) == 0 || (height.sign(1) != height.sign(0) && height.sign(2) != height.sign(3)))
            return false;
        return std::all_of(agreement.begin(), agreement.end(), [](const auto& q) { return q.sign() > 0; });
    }

private:
    /// Is there a corner d_i whose own direction has every corner in front of it?
    template <class Sign>
    bool some_corner_faces_all(const Sign& sign) const
    {
        std::array<bool, Corners> faces_all;
        faces_all.fill(true);
        std::size_t pair = 0;
        for (std::size_t i = 0; i < Corners; ++i)
            for (std::size_t j = i + 1; j < Corners; ++j, ++pair)
                if (sign(alignment[pair]) <= 0)
                    faces_all[i] = faces_all[j] = false;
        return std::find(faces_all.begin(), faces_all.end(), true) != faces_all.end();
    }
};
//! [directions]

template <class Real>
SeparatingDirections<Real, 3> separating_directions(const VertexFaceDifferences<Real>& d, int halvings)
{
    const auto n0 = cross(d.d1, d.d2), n1 = cross(d.d2, d.d0), n2 = cross(d.d0, d.d1);
    return {dot(d.d0, n0, halvings),
            {dot(n0, n1, halvings), dot(n1, n2, halvings), dot(n2, n0, halvings)},
            {dot(d.d0, d.d1, halvings), dot(d.d0, d.d2, halvings), dot(d.d1, d.d2, halvings)}};
}

template <class Real>
SeparatingDirections<Real, 4> separating_directions(const EdgeEdgeDifferences<Real>& d, int halvings)
{
    const auto a_from_1 = cross(d.b, d.d00), a_from_0 = cross(d.d10, d.b);
    const auto b_from_1 = cross(d.a, d.d00), b_from_0 = cross(d.d01, d.a);
    return {dot(d.a, a_from_1, halvings),
            {dot(a_from_1, a_from_0, halvings), dot(b_from_1, b_from_0, halvings)},
            {dot(d.d00, d.d01, halvings), dot(d.d00, d.d10, halvings), dot(d.d00, d.d11, halvings),
             dot(d.d01, d.d10, halvings), dot(d.d01, d.d11, halvings), dot(d.d10, d.d11, halvings)}};
}

template <class Real, std::size_t Corners>
std::pair<SeparatingDirections<Real, Corners>, SeparatingDirections<Real, Corners>>
halves(const SeparatingDirections<Real, Corners>& whole)
{
    std::pair<SeparatingDirections<Real, Corners>, SeparatingDirections<Real, Corners>> parts;
    std::tie(parts.first.height, parts.second.height) = halves(whole.height);
    for (std::size_t i = 0; i < whole.agreement.size(); ++i)
        std::tie(parts.first.agreement[i], parts.second.agreement[i]) = halves(whole.agreement[i]);
    for (std::size_t i = 0; i < whole.alignment.size(); ++i)
        std::tie(parts.first.alignment[i], parts.second.alignment[i]) = halves(whole.alignment[i]);
    return parts;
}

/// The same tests for the rest of the step after s.
template <class Real, std::size_t Corners>
SeparatingDirections<Real, Corners> from(SeparatingDirections<Real, Corners> directions, double s)
{
    directions.height = from(directions.height, s);
    for (auto& q : directions.agreement)
        q = from(q, s);
    for (auto& p : directions.alignment)
        p = from(p, s);
    return directions;
}

}  // namespace enduring::certified
