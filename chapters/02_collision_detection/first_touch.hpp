#pragma once

#include "chapters/02_collision_detection/certificates.hpp"
#include "chapters/02_collision_detection/certified.hpp"

#include <optional>

namespace enduring::certified {

/// `open`: no contact before `time`, and too close to call from there on at this precision.
enum class Verdict { apart, touch, open };

template <class Real>
struct Touch {
    Verdict verdict;
    Real time;
};

template <class Real, template <class> class Differences>
Differences<MovingVector<Real, 0>> at(const Differences<MovingDifference<Real>>& motion, const Real& time)
{
    Differences<MovingVector<Real, 0>> result;
    for (std::size_t i = 0; i < motion.v.size(); ++i)
        result.v[i] = at(motion.v[i], time);
    return result;
}

template <class Real, template <class> class Differences>
Differences<Vec3> rates(const Differences<MovingDifference<Real>>& motion)
{
    Differences<Vec3> result;
    for (std::size_t i = 0; i < motion.v.size(); ++i)
        result.v[i] = rounded(motion.v[i].c[1] + minus(motion.v[i].c[0]));
    return result;
}

/// The same in doubles.
template <class Real, template <class> class Differences>
Differences<MovingVector<double, 0>> in_doubles(const Differences<MovingVector<Real, 0>>& d)
{
    Differences<MovingVector<double, 0>> result;
    for (std::size_t i = 0; i < d.v.size(); ++i) {
        const auto& [x, y, z] = d.v[i].c[0];
        result.v[i] = {{{{rounded(x), rounded(y), rounded(z)}}},
                       d.v[i].size,
                       d.v[i].error + Precision<double>::unit * d.v[i].size};
    }
    return result;
}

//! [crossing]
/// Whether the origin is in the polygon at all times of a short span from `there` on.
/// @return +1 certainly, -1 certainly not, as far as the sides tell, 0 too close to call
template <template <class> class Differences>
int within_sides(const Differences<MovingVector<double, 0>>& there, double span)
{
    std::array<MovingVector<double, 0>, Differences<double>::corners> sides;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        sides[i] = side(there, i);
        sides[i].error += 4 * span * sides[i].size;  // a quadratic changes at most by 4 sizes in the step
    }
    bool inside = false;
    for (const auto axis : axes<double>) {
        const Signs seen = signs(sides, axis);
        if (seen.some_disagree())
            return -1;
        inside = inside || seen.all_agree();
    }
    return inside ? 1 : 0;
}

/// Certainly the height vanishes exactly once in the step, changing sign.
inline bool changes_once(const BoundedPolynomial<double, 3>& height)
{
    const std::array<int, 4> s{height.sign(0), height.sign(1), height.sign(2), height.sign(3)};
    return s[0] * s[3] < 0 && s[1] * s[2] != 0 && (s[1] == s[0] || s[2] == s[3]);
}

/// The usual case in doubles: the first root of the height is enclosed, and the sides tell whether the origin
/// is in the polygon there. Where they do not, it is open from just before the root on.
template <template <class> class Differences>
Touch<double> touch_at_root(const Differences<MovingDifference<double>>& motion,
                            const BoundedPolynomial<double, 3>& height)
{
    const auto& c = height.c;
    const double sign = c[0] > 0 ? 1 : -1;
    const double root = first_zero(
        {sign * c[0], sign * 3 * (c[1] - c[0]), sign * 3 * (c[2] - 2 * c[1] + c[0]),
         sign * (c[3] - 3 * c[2] + 3 * c[1] - c[0])},
        1);
    const double from = root - 0.4 * time_of_impact_slack, to = root + 0.4 * time_of_impact_slack;
    if (!(from > 0 && to < 1))
        return {Verdict::open, 0};
    const BoundedPolynomial<double, 3> before = up_to(height, from);
    if (before.sign() != sign || !(sign * value_at(c, to) < -before.error))
        return {Verdict::open, 0};
    const int within = within_sides(at(motion, from), to - from);
    if (within < 0 && changes_once(height))
        return {Verdict::apart, 1};
    return {within > 0 ? Verdict::touch : Verdict::open, from};
}
//! [crossing]

//! [in_plane]
/// Whether a moment after `time` the origin is in the polygon, as doubles tell, and no height is to be seen
/// with 106 bits. Then no proof holds there: it is a touch.
template <template <class> class Differences>
bool touches_in_plane(const Differences<MovingDifference<double>>& motion,
                      const Differences<MovingDifference<DoubleDouble>>& fine, double time)
{
    const double then = std::min(1.0, time + 0.4 * time_of_impact_slack);
    const auto there = at(motion, then);
    if (height(there).sign() != 0 || within_sides(there, 0) <= 0)
        return false;
    const auto [i, j, k] = Differences<double>::height;
    const auto fine_at = [&](std::size_t n) { return at(fine.v[n], DoubleDouble(then)); };
    return dot(fine_at(i), cross(fine_at(j), fine_at(k))).sign() == 0;
}
//! [in_plane]

/// How many proofs one query takes in each precision, and how much shorter than proposed one of them may be.
constexpr int most_proofs = 64;
constexpr double shortest = 0x1p-40;

/// Where a proof is proposed a little too long by rounding, this little less of it holds.
constexpr double a_little_less = 1 - 0x1p-45;

template <class Real>
double left_of_step(const Real& time)
{
    return rounded(Real(1.0) - time);
}

//! [go_on]
/// Goes on from `time` to the end of a proof, or where the proof does not hold so long, to a half, a quarter,
/// ... of it.
template <class Real, template <class> class Differences>
bool go_on(const Certificate& proof, const Differences<MovingDifference<Real>>& motion, double rest,
           Real& time, Differences<MovingVector<Real, 0>>& now)
{
    double length = proof.length;
    for (double less = a_little_less; length > shortest * proof.length; length *= less, less = 0.5) {
        const Real end = length >= rest ? Real(1.0) : time + Real(length);
        if (!holds<Real, Differences>(proof, motion, now, end))
            continue;
        const bool moved = time < end;
        time = end;
        now = at(motion, end);
        return moved;
    }
    return false;
}
//! [go_on]

//! [search]
/// First contact from `time` on, by a chain of proofs: take the proof that is likely to hold longest, and go
/// to its end. What no proof excludes there is open; where the height changes its sign within the polygon, it
/// is a touch.
template <class Real, template <class> class Differences>
Touch<Real> first_touch(const Differences<MovingDifference<Real>>& motion, Real time)
{
    const Differences<Vec3> speed = rates(motion);
    auto now = at(motion, time);
    for (int n = 0; n < most_proofs; ++n) {
        const double rest = left_of_step(time);
        const Certificate proof = Instant<Real, Differences>{motion, now, speed, rest}.longest();
        if (proof.kind == Certificate::Kind::none || !go_on(proof, motion, rest, time, now))
            return {Verdict::open, time};
        if (!(time < Real(1.0)))
            return {Verdict::apart, time};
        if (proof.kind == Certificate::Kind::height && left_of_step(time) > time_of_impact_slack &&
            height(at(motion, time + Real(time_of_impact_slack))).sign(0) == -proof.sign &&
            within_sides(in_doubles(now), time_of_impact_slack) > 0)
            return {Verdict::touch, time};
    }
    return {Verdict::open, time};
}
//! [search]

}  // namespace enduring::certified
