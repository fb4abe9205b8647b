#pragma once

#include "chapters/02_collision_detection/separating_directions.hpp"

#include <cmath>

namespace enduring::certified {

/// The first s in [0, length] at which f, in powers of s, is not positive; or `length`. In plain doubles: a
/// proposal.
double first_zero(const std::array<double, 4>& f, double length);

/// The same for a proof: where f is positive up to `length` and Bernstein coefficients do not show it, how
/// far it is to where f turns.
double provable_length(const std::array<double, 4>& f, double length);

//! [certificates]
/// A proof that the origin is outside the polygon: a sign that holds. There are three kinds (see the page):
/// all corners on one side along an axis, two sides opposed along an axis, the height not zero.
struct Certificate {
    enum class Kind { none, corners, sides, height };

    Kind kind = Kind::none;
    int sign = 0;  ///< of the corners, of side `one`, or of the height
    std::size_t axis = 0, one = 0, other = 0;
    double length = 0;  ///< how long it is likely to hold from now on [parts of the step]
};
//! [certificates]

/// One component of the cross product of two moving differences.
template <class Real>
BoundedPolynomial<Real, 2> cross_component(const MovingDifference<Real>& a, const MovingDifference<Real>& b,
                                           std::size_t axis)
{
    const auto l = axes<Real>[(axis + 1) % 3], m = axes<Real>[(axis + 2) % 3];
    const auto product = [&](std::size_t i, std::size_t j) {
        return a.c[i].*l * b.c[j].*m - a.c[i].*m * b.c[j].*l;
    };
    return {{product(0, 0), half(product(0, 1) + product(1, 0)), product(1, 1)}, cross_bound(a, b)};
}

/// Of a sign, what is left of a value beyond this many of its errors: there a new proof has to take over.
constexpr double handed_over = 1.1;

/// Rates that are smaller than this part of what they are made of are rounding in doubles: then they come
/// from Real.
constexpr double only_rounding = 0x1p-40;

/// Where all differences of a motion are at one time, and how fast they move.
template <class Real, template <class> class Differences>
struct Instant {
    static constexpr std::size_t corners = Differences<Real>::corners;

    const Differences<MovingDifference<Real>>& motion;
    const Differences<MovingVector<Real, 0>>& at;  ///< now
    const Differences<Vec3>& rates;
    double rest;  ///< of the step

    /// The proof among the three kinds that is likely to hold longest; cheap ones first, and no other where
    /// one lasts to the end.
    Certificate longest() const
    {
        Certificate best;
        for (std::size_t axis = 0; axis < 3; ++axis)
            keep_longer(best, by_corners(axis));
        if (best.length >= rest)
            return best;
        std::array<MovingVector<Real, 0>, corners> sides;
        for (std::size_t i = 0; i < corners; ++i)
            sides[i] = side(at, i);
        look_at_sides(best, sides);
        if (best.length < rest)
            keep_longer(best, by_height(dot(at.v[Differences<Real>::height[0]], sides[0])));
        return best;
    }

private:
    static void keep_longer(Certificate& best, const Certificate& other)
    {
        if (other.length > best.length)
            best = other;
    }

    Certificate by_corners(std::size_t axis) const
    {
        const auto component = axes<Real>[axis];
        Certificate proof{Certificate::Kind::corners, rounded(at.v[0].c[0].*component) > 0 ? 1 : -1, axis};
        proof.length = rest;
        for (std::size_t i = 0; i < corners; ++i) {
            const double value = proof.sign * rounded(at.v[i].c[0].*component) - handed_over * at.v[i].error,
                         rate = proof.sign * rates.v[i][static_cast<Eigen::Index>(axis)];
            if (!(value > 0))
                return {};
            if (value + proof.length * rate < 0)
                proof.length = value / -rate;
        }
        return proof;
    }

    /// How long a component of a side keeps its sign.
    double lasts(std::size_t i, std::size_t axis, double value) const
    {
        const auto [p, q] = Differences<Real>::sides[i];
        const Vec3 a = rounded(at.v[p].c[0]), b = rounded(at.v[q].c[0]);
        const Vec3 &a_rate = rates.v[p], &b_rate = rates.v[q];
        const auto k = static_cast<Eigen::Index>(axis), l = (k + 1) % 3, m = (k + 2) % 3;
        const double sign = value > 0 ? 1 : -1,
                     first = a_rate[l] * b[m] - a_rate[m] * b[l] + a[l] * b_rate[m] - a[m] * b_rate[l],
                     second = a_rate[l] * b_rate[m] - a_rate[m] * b_rate[l];
        if (std::max(std::abs(first), std::abs(second)) > only_rounding * at.v[p].size * at.v[q].size)
            return provable_length({sign * value, sign * first, sign * second, 0}, rest);
        const auto [b0, b1, b2] = cross_component(between(at.v[p], end_of(motion.v[p])),
                                                  between(at.v[q], end_of(motion.v[q])), axis)
                                      .c;
        return provable_length({sign * value, sign * 2 * rounded(b1 - b0) / rest,
                                sign * rounded((b2 - b1) + (b0 - b1)) / (rest * rest), 0},
                               rest);
    }

    void look_at_sides(Certificate& best, const std::array<MovingVector<Real, 0>, corners>& normals) const
    {
        for (std::size_t axis = 0; axis < 3 && best.length < rest; ++axis) {
            std::array<double, 2> longest{};  // of a positive side and of a negative one
            std::array<std::size_t, 2> which{};
            std::array<double, corners> beyond{};  // the error
            for (std::size_t i = 0; i < corners; ++i) {
                const double value = rounded(normals[i].c[0].*axes<Real>[axis]),
                             error = handed_over * normals[i].error;
                beyond[i] = value > error ? value - error : value < -error ? value + error : 0;
            }
            const Signs seen = signs_of(beyond);
            for (std::size_t i = 0; i < corners && seen.some_disagree(); ++i) {
                if (beyond[i] == 0)
                    continue;
                const double length = lasts(i, axis, beyond[i]);
                const std::size_t s = beyond[i] > 0 ? 0 : 1;
                if (length > longest[s])
                    longest[s] = length, which[s] = i;
            }
            keep_longer(best, {Certificate::Kind::sides, 1, axis, which[0], which[1],
                               std::min(longest[0], longest[1])});
        }
    }

    Certificate by_height(const BoundedPolynomial<Real, 0>& now) const
    {
        const double value = rounded(now.c[0]), beyond = std::abs(value) - handed_over * now.error;
        if (!(beyond > 0))
            return {};
        const auto [i, j, k] = Differences<Real>::height;
        const Vec3 a = rounded(at.v[i].c[0]), b = rounded(at.v[j].c[0]), c = rounded(at.v[k].c[0]);
        const Vec3 &a_rate = rates.v[i], &b_rate = rates.v[j], &c_rate = rates.v[k];
        const Vec3 n0 = b.cross(c), n1 = b_rate.cross(c) + b.cross(c_rate), n2 = b_rate.cross(c_rate);
        Vec3 f(a_rate.dot(n0) + a.dot(n1), a_rate.dot(n1) + a.dot(n2), a_rate.dot(n2));
        if (f.cwiseAbs().maxCoeff() <= only_rounding * at.v[i].size * at.v[j].size * at.v[k].size) {
            const auto moving = [&](std::size_t n) { return between(at.v[n], end_of(motion.v[n])); };
            const auto [b0, b1, b2, b3] = dot(moving(i), cross(moving(j), moving(k))).c;
            f = {3 * rounded(b1 - b0) / rest, 3 * rounded((b2 - b1) + (b0 - b1)) / (rest * rest),
                 rounded((b3 - b0) + Real(3.0) * (b1 - b2)) / (rest * rest * rest)};
        }
        const double sign = value > 0 ? 1 : -1;
        return {Certificate::Kind::height,
                value > 0 ? 1 : -1,
                0,
                0,
                0,
                provable_length({beyond, sign * f[0], sign * f[1], sign * f[2]}, rest)};
    }
};

/// Whether a certificate certainly holds from now to another time.
template <class Real, template <class> class Differences>
bool holds(const Certificate& proof, const Differences<MovingDifference<Real>>& motion,
           const Differences<MovingVector<Real, 0>>& now, const Real& end)
{
    using D = Differences<Real>;
    const auto then = [&](std::size_t i) { return at(motion.v[i], end); };
    const auto moving = [&](std::size_t i) { return between(now.v[i], then(i)); };
    if (proof.kind == Certificate::Kind::corners) {
        for (std::size_t i = 0; i < D::corners; ++i)  // on straight lines: both ends are enough
            if (then(i).component(axes<Real>[proof.axis]).sign() != proof.sign)
                return false;
        return true;
    }
    if (proof.kind == Certificate::Kind::sides) {
        const auto sign = [&](std::size_t i) {
            return cross_component(moving(D::sides[i][0]), moving(D::sides[i][1]), proof.axis).sign();
        };
        return sign(proof.one) == proof.sign && sign(proof.other) == -proof.sign;
    }
    const auto [i, j, k] = D::height;
    return dot(moving(i), cross(moving(j), moving(k))).sign() == proof.sign;
}

}  // namespace enduring::certified
