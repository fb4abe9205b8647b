#include "chapters/03_penalty_impulses/penetration.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace enduring;

namespace {

/// The cubic scale (tau - r0)(tau - r1)(tau - r2) in Bernstein form,
/// through its blossom (exact up to rounding).
Bernstein<double, 3> from_roots(double scale, double r0, double r1, double r2)
{
    // symmetric, and the cubic itself on the diagonal
    const auto blossom = [&](double u, double v, double w) {
        return scale * (u * v * w - (r0 + r1 + r2) * (u * v + v * w + u * w) / 3 +
                        (r0 * r1 + r1 * r2 + r0 * r2) * (u + v + w) / 3 - r0 * r1 * r2);
    };
    return {{blossom(0, 0, 0), blossom(0, 0, 1), blossom(0, 1, 1), blossom(1, 1, 1)}};
}

bool covers(const PenetrationIntervals& intervals, double tau)
{
    return std::any_of(intervals.begin(), intervals.end(),
                       [&](const Interval& part) { return part.from <= tau && tau <= part.to; });
}

}  // namespace

TEST_CASE("penetration intervals: between the roots of a known cubic, at most two of them")
{
    const auto two = penetration_intervals(from_roots(1, 0.2, 0.5, 0.9));  // - + - +
    REQUIRE(two.size() == 2);
    CHECK(two[0].from == 0);
    CHECK(two[0].to == doctest::Approx(0.2).epsilon(1e-14));
    CHECK(two[1].from == doctest::Approx(0.5).epsilon(1e-14));
    CHECK(two[1].to == doctest::Approx(0.9).epsilon(1e-14));

    const auto one = penetration_intervals(from_roots(1, -1, 0.3, 0.6));  // + - +
    REQUIRE(one.size() == 1);
    CHECK(one[0].from == doctest::Approx(0.3).epsilon(1e-14));
    CHECK(one[0].to == doctest::Approx(0.6).epsilon(1e-14));

    CHECK(penetration_intervals(from_roots(1, -1, -2, -3)).size() == 0);
    const auto throughout = penetration_intervals(from_roots(-1, -1, -2, -3));
    REQUIRE(throughout.size() == 1);
    CHECK(throughout[0].from == 0);
    CHECK(throughout[0].to == 1);
}

TEST_CASE("penetration intervals: they hold the negative values of random cubics and no others")
{
    std::mt19937_64 generator(36);
    std::uniform_real_distribution<double> unit(-1, 1);
    int count[3] = {0, 0, 0};
    for (int round = 0; round < 20000; ++round) {
        const Bernstein<double, 3> depth{
            {unit(generator), unit(generator), unit(generator), unit(generator)}};
        const double start = round % 3 == 0 ? 0.5 * (unit(generator) + 1) : 0;
        CAPTURE(round);
        CAPTURE(start);
        const auto inside = penetration_intervals(depth, start);
        ++count[inside.size()];
        int wrong = 0;
        double last = start;
        for (const Interval& part : inside) {
            CHECK(part.from >= last);
            CHECK(part.to >= part.from);
            last = part.to;
        }
        CHECK(last <= 1);
        for (int i = 0; i <= 100; ++i) {
            const double tau = std::min(1.0, start + (1 - start) * i / 100);
            wrong += std::abs(depth(tau)) > 1e-14 && covers(inside, tau) != (depth(tau) < 0);
        }
        CHECK(wrong == 0);
    }
    CHECK(count[0] > 100);
    CHECK(count[1] > 100);
    CHECK(count[2] > 100);  // the case of two intervals is met, not only allowed
}

TEST_CASE("penetration intervals: near double and triple roots nothing deeper than rounding is missed")
{
    std::mt19937_64 generator(37);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int round = 0; round < 20000; ++round) {
        const double root = unit(generator), gap = std::pow(10.0, -16 * unit(generator));
        const double other = round % 2 == 0 ? root + gap * gap : 3 * unit(generator) - 1;
        const Bernstein<double, 3> depth = from_roots(round % 4 < 2 ? 1 : -1, root, root + gap, other);
        CAPTURE(root);
        CAPTURE(gap);
        CAPTURE(other);
        const auto inside = penetration_intervals(depth);
        int wrong = 0;
        for (int i = 0; i <= 200; ++i) {
            const double tau = i < 100 ? i / 100.0 : root + gap * (i - 150) / 25.0;
            if (tau < 0 || tau > 1)
                continue;
            wrong += covers(inside, tau) ? depth(tau) > 1e-14 : depth(tau) < -1e-14;
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE("penetration intervals: a pair that starts at its impact is not pushed before it")
{
    const auto inside = penetration_intervals({{-1.0, -1.0, -1.0, -1.0}}, 0.25);
    REQUIRE(inside.size() == 1);
    CHECK(inside[0].from == 0.25);
    CHECK(penetration_intervals({{1.0, 1.0, -1.0, -1.0}}, 1).size() <= 1);

    // Negative before 0.2 and from 0.4 to 0.7, or the other way round:
    // the visit before the start is nobody's.
    for (const double sign : {1.0, -1.0}) {
        const auto rest = penetration_intervals(from_roots(sign, 0.2, 0.4, 0.7), 0.5);
        REQUIRE(rest.size() == 1);
        CHECK(rest[0].from == doctest::Approx(sign > 0 ? 0.5 : 0.7));
        CHECK(rest[0].to == doctest::Approx(sign > 0 ? 0.7 : 1));
    }
}
