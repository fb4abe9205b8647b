#include "chapters/02_collision_detection/tests/exact_oracle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace enduring::exact {
namespace {

/// A point or a vector that moves polynomially, exactly.
using Moving = std::array<Polynomial, 3>;

/// Coordinates times the power of two that makes all of them integers.
class Scale {
public:
    template <class... Points>
    explicit Scale(const Points&... points)
    {
        for (const Vec3& point : {points...})
            for (const double x : point)
                if (x != 0)
                    lowest_ = std::min(lowest_, std::ilogb(x) - 52);
    }

    Moving moving(const Vec3& start, const Vec3& end) const
    {
        Moving result;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto k = static_cast<Eigen::Index>(i);
            result[i] = Polynomial({integer(start[k]), integer(end[k]) - integer(start[k])});
        }
        return result;
    }

private:
    Integer integer(double x) const
    {
        if (x == 0)
            return 0;
        const int exponent = std::ilogb(x) - 52;
        return Integer(std::ldexp(x, -exponent)) << (exponent - lowest_);
    }

    int lowest_ = std::numeric_limits<int>::max();
};

Moving operator-(const Moving& a, const Moving& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Polynomial dot(const Moving& a, const Moving& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Moving cross(const Moving& a, const Moving& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Signs that decide whether a moving point lies on a moving segment.
struct PointOnSegment {
    Moving area;         ///< zero on the segment's line
    Polynomial between;  ///< not positive between its ends

    PointOnSegment(const Moving& p, const Moving& a, const Moving& b)
        : area(cross(p - a, p - b)), between(dot(p - a, p - b))
    {}

    bool holds(AlgebraicNumber& t) const
    {
        return std::all_of(area.begin(), area.end(),
                           [&](const Polynomial& q) { return t.sign_of(q) == 0; }) &&
               t.sign_of(between) <= 0;
    }
};

/// The conditions of one query: with a normal, the volume is zero and no
/// weight negative; without, a point on a segment.
struct Conditions {
    Polynomial volume, normal_squared;
    std::vector<Polynomial> weights;
    std::vector<PointOnSegment> points;

    bool hold(AlgebraicNumber& t) const
    {
        if (t.sign_of(normal_squared) > 0)
            return t.sign_of(volume) == 0 &&
                   std::all_of(weights.begin(), weights.end(),
                               [&](const Polynomial& w) { return t.sign_of(w) >= 0; });
        return std::any_of(points.begin(), points.end(), [&](const PointOnSegment& p) { return p.holds(t); });
    }

    /// Touching begins only at a root of one of these, or with the step.
    std::vector<Polynomial> events() const
    {
        if (!volume.is_zero())
            return {volume};
        std::vector<Polynomial> all = weights;
        all.push_back(normal_squared);
        for (const PointOnSegment& p : points) {
            all.insert(all.end(), p.area.begin(), p.area.end());
            all.push_back(p.between);
        }
        return all;
    }
};

FirstTouch enclosed(AlgebraicNumber t)
{
    // Every halving doubles the denominator of the ends, so these are never closer than 2^-70.
    while (!(t.low == t.high) && t.high.power < 70)
        t.refine();
    return {t.low, t.high};
}

std::optional<FirstTouch> first_touch(const Conditions& conditions)
{
    AlgebraicNumber start{};
    if (conditions.hold(start))
        return FirstTouch{};
    std::optional<FirstTouch> first;
    for (const Polynomial& event : conditions.events()) {
        if (event.is_zero())
            continue;
        for (AlgebraicNumber& t : roots_in_step(event))
            if (conditions.hold(t)) {
                const FirstTouch touch = enclosed(t);
                if (!first || touch.high < first->high)
                    first = touch;
                break;  // the roots ascend
            }
    }
    return first;
}

}  // namespace

std::optional<FirstTouch> first_touch(const VertexFaceStep& s)
{
    const Scale scale(s.v_t0, s.v_t1, s.f0_t0, s.f0_t1, s.f1_t0, s.f1_t1, s.f2_t0, s.f2_t1);
    const Moving v = scale.moving(s.v_t0, s.v_t1), f0 = scale.moving(s.f0_t0, s.f0_t1);
    const Moving f1 = scale.moving(s.f1_t0, s.f1_t1), f2 = scale.moving(s.f2_t0, s.f2_t1);
    const Moving normal = cross(f1 - f0, f2 - f0);
    return first_touch(Conditions{dot(normal, v - f0),
                                  dot(normal, normal),
                                  {dot(normal, cross(f2 - f1, v - f1)), dot(normal, cross(f0 - f2, v - f2)),
                                   dot(normal, cross(f1 - f0, v - f0))},
                                  {{v, f0, f1}, {v, f1, f2}, {v, f2, f0}}});
}

std::optional<FirstTouch> first_touch(const EdgeEdgeStep& s)
{
    const Scale scale(s.ea0_t0, s.ea0_t1, s.ea1_t0, s.ea1_t1, s.eb0_t0, s.eb0_t1, s.eb1_t0, s.eb1_t1);
    const Moving a0 = scale.moving(s.ea0_t0, s.ea0_t1), a1 = scale.moving(s.ea1_t0, s.ea1_t1);
    const Moving b0 = scale.moving(s.eb0_t0, s.eb0_t1), b1 = scale.moving(s.eb1_t0, s.eb1_t1);
    const Moving a = a1 - a0, b = b1 - b0, normal = cross(a, b);
    const Polynomial weight_a = dot(cross(b0 - a0, b), normal), weight_b = dot(cross(b0 - a0, a), normal),
                     whole = dot(normal, normal);
    return first_touch(Conditions{dot(normal, b0 - a0),
                                  whole,
                                  {weight_a, whole - weight_a, weight_b, whole - weight_b},
                                  {{a0, b0, b1}, {a1, b0, b1}, {b0, a0, a1}, {b1, a0, a1}}});
}

}  // namespace enduring::exact
