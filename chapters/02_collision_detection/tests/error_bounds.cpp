#include "chapters/02_collision_detection/first_touch.hpp"
#include "chapters/02_collision_detection/tests/step_generators.hpp"

#include <doctest/doctest.h>
#include <boost/multiprecision/cpp_int.hpp>

using namespace enduring;
using namespace enduring::certified;
using namespace enduring::generated;
using Rational = boost::multiprecision::cpp_rational;

namespace {

Rational exact(double a) { return Rational(a); }
Rational exact(DoubleDouble a) { return Rational(a.hi) + Rational(a.lo); }

using ExactVector = std::array<Rational, 3>;

ExactVector difference(const Vec3& a, const Vec3& b)
{
    return {Rational(a[0]) - Rational(b[0]), Rational(a[1]) - Rational(b[1]),
            Rational(a[2]) - Rational(b[2])};
}

Rational volume(const ExactVector& a, const ExactVector& b, const ExactVector& c)
{
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Bernstein coefficients of the volume of three moving differences: coefficient i is the mean over all
/// choices of i differences taken at the end of the step, the others at its start.
std::array<Rational, 4> exact_height(const Points& p)
{
    const auto d = [&](std::size_t corner, std::size_t end) {
        return difference(p[4 * end], p[corner + 4 * end]);
    };
    std::array<Rational, 4> c;
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j)
            for (std::size_t k = 0; k < 2; ++k)
                c[i + j + k] += volume(d(1, i), d(2, j), d(3, k));
    c[1] /= 3;
    c[2] /= 3;
    return c;
}

/// The polynomial over a part of the step: coefficient i is the blossom of i times `to` and else `from`.
std::array<Rational, 4> over_part(const std::array<Rational, 4>& c, const Rational& from, const Rational& to)
{
    std::array<Rational, 4> result;
    for (std::size_t i = 0; i < 4; ++i) {
        std::array<Rational, 4> blossom = c;
        for (std::size_t round = 1; round < 4; ++round) {
            const Rational& at = round <= i ? to : from;
            for (std::size_t k = 0; k + round < 4; ++k)
                blossom[k] = (1 - at) * blossom[k] + at * blossom[k + 1];
        }
        result[i] = blossom[0];
    }
    return result;
}

template <class Real>
double largest_share(const BoundedPolynomial<Real, 3>& computed, const std::array<Rational, 4>& truth)
{
    double share = 0;
    for (std::size_t i = 0; i < 4; ++i)
        share = std::max(
            share,
            Rational(abs(exact(computed.c[i]) - truth[i]) / Rational(computed.error)).convert_to<double>());
    return share;
}

/// Largest error of a coefficient of the height over the step and over a part of it, in parts of its bound.
template <class Real>
double worst_share(const Points& points, double from, double to)
{
    const auto motion = differences<Real>(step_of<VertexFaceStep>(points));
    const std::array<Rational, 4> truth = exact_height(points);
    const auto start = at(motion, Real(from)), end = at(motion, Real(to));
    VertexFaceDifferences<MovingDifference<Real>> part;
    for (std::size_t i = 0; i < part.v.size(); ++i)
        part.v[i] = between(start.v[i], end.v[i]);
    return std::max(largest_share(height(motion), truth),
                    largest_share(height(part), over_part(truth, Rational(from), Rational(to))));
}

template <class Real>
void require_bounds_hold()
{
    Random random(11);
    double worst = 0;
    for (const Category& category : categories())
        for (int i = 0; i < 40; ++i) {
            CAPTURE(category.name);
            CAPTURE(i);
            const Points points = category.make(random, false);
            const double from = random.uniform(0, 0.5);
            const double share = worst_share<Real>(points, from, random.uniform(from, 1));
            CHECK(share <= 1);
            worst = std::max(worst, share);
        }
    // A bound that is never approached would send easy pairs to the slow stage.
    CHECK(worst > 1e-3);
}

}  // namespace

TEST_CASE("error bounds: no coefficient of the height in doubles is off by more than its bound says")
{
    require_bounds_hold<double>();
}

TEST_CASE("error bounds: no coefficient of the height in double-doubles is off by more than its bound says")
{
    require_bounds_hold<DoubleDouble>();
}

TEST_CASE_TEMPLATE("error bounds: no side at an instant is off by more than its bound says", Real, double,
                   DoubleDouble)
{
    Random random(15);
    for (const Category& category : categories())
        for (int i = 0; i < 20; ++i) {
            CAPTURE(category.name);
            CAPTURE(i);
            const Points p = category.make(random, false);
            const double time = random.uniform(0, 1);
            const auto computed = side(at(differences<Real>(step_of<VertexFaceStep>(p)), Real(time)), 0);
            const auto component = [&](std::size_t corner, Eigen::Index k) {
                const Rational start = Rational(p[0][k]) - Rational(p[corner][k]),
                               end = Rational(p[4][k]) - Rational(p[corner + 4][k]);
                return Rational(start + Rational(time) * (end - start));
            };
            const Rational truth = component(2, 1) * component(3, 2) - component(2, 2) * component(3, 1);
            CHECK(abs(exact(computed.c[0].x) - truth) <= Rational(computed.error));
            CHECK(abs(truth) <= Rational(computed.size));
        }
}

TEST_CASE("proofs: the first zero of a product of linear factors is its smallest root, from below")
{
    Random random(16);
    for (int i = 0; i < 2000; ++i) {
        std::array<double, 3> roots;
        for (double& root : roots)
            root = random.integer(0, 3) == 0 ? random.uniform(1.1, 3) : random.uniform(0.01, 0.99);
        const auto [a, b, c] = roots;
        const double first = std::min({a, b, c, 1.0});
        CAPTURE(i);
        const double found = first_zero({a * b * c, -(a * b + b * c + c * a), a + b + c, -1}, 1);
        CHECK(found <= first + 1e-6);
        CHECK(found >= first - 1e-6);
    }
    CHECK(first_zero({1, -4, 0, 0}, 1) == 0.25);
    CHECK(first_zero({1, 4, 0, 0}, 1) == 1);
    CHECK(first_zero({1, -4, 5, 0}, 0.7) == 0.7);
}

TEST_CASE("error bounds: no coefficient of the height up to a time is off by more than its bound says")
{
    Random random(17);
    for (const Category& category : categories())
        for (int i = 0; i < 40; ++i) {
            CAPTURE(category.name);
            CAPTURE(i);
            const Points points = category.make(random, false);
            const double end = random.uniform(0, 1);
            const auto motion = differences<double>(step_of<VertexFaceStep>(points));
            CHECK(largest_share(up_to(height(motion), end),
                                over_part(exact_height(points), 0, Rational(end))) <= 1);
        }
}

TEST_CASE("proofs: where a cubic only turns, its coefficients show its sign up to there")
{
    // s + small on both sides of a double zero, and a third zero beyond the step or none
    Random random(18);
    for (int i = 0; i < 2000; ++i) {
        const double turn = random.uniform(0.05, 0.95), least = std::ldexp(1.0, -random.integer(10, 40)),
                     third = random.integer(0, 1) * random.uniform(-0.4, 0.9);
        // ((s - turn)^2 + least) (1 - third s)
        const std::array<double, 4> f{turn * turn + least, -2 * turn - third * (turn * turn + least),
                                      1 + 2 * third * turn, -third};
        const double length = provable_length(f, 1);
        CAPTURE(i);
        CAPTURE(length);
        CHECK(length > 0.5 * turn);
        const double b = f[1] * length / 3, c = f[2] * length * length / 3;
        CHECK(f[0] + b > 0);
        CHECK(f[0] + 2 * b + c > 0);
    }
    CHECK(provable_length({1, -4, 0, 0}, 1) == 0.25);
    CHECK(provable_length({1, 4, 0, 0}, 1) == 1);
}

TEST_CASE("double-double: sums and products of doubles are exact")
{
    Random random(12);
    for (int i = 0; i < 2000; ++i) {
        const double a = std::ldexp(random.uniform(-1, 1), random.integer(-60, 60)),
                     b = std::ldexp(random.uniform(-1, 1), random.integer(-60, 60));
        CAPTURE(a);
        CAPTURE(b);
        CHECK(exact(two_sum(a, b)) == Rational(a) + Rational(b));
        CHECK(exact(two_difference(a, b)) == Rational(a) - Rational(b));
        CHECK(exact(two_product(a, b)) == Rational(a) * Rational(b));
    }
}

TEST_CASE("double-double: sums and products keep a relative error of 2^-103, also where they cancel")
{
    Random random(13);
    const Rational allowed = Rational(1) / (boost::multiprecision::cpp_int(1) << 103);
    for (int i = 0; i < 2000; ++i) {
        const DoubleDouble a = two_product(random.uniform(-1, 1), random.uniform(-1, 1));
        const DoubleDouble near = two_sum(-a.hi, std::ldexp(random.uniform(-1, 1), -random.integer(1, 100)));
        const DoubleDouble b = random.integer(0, 1)
                                   ? near
                                   : two_product(random.uniform(-1, 1), random.uniform(-1, 1));
        CAPTURE(i);
        const Rational sum = exact(a) + exact(b), product = exact(a) * exact(b);
        CHECK(abs(exact(a + b) - sum) <= allowed * abs(sum));
        CHECK(abs(exact(a - b) - (exact(a) - exact(b))) <= allowed * abs(exact(a) - exact(b)));
        CHECK(abs(exact(a * b) - product) <= allowed * abs(product));
    }
}

TEST_CASE("proofs: at an instant none of the three kinds excludes a contact, and one excludes all else")
{
    Random random(14);
    for (int i = 0; i < 2000; ++i) {
        Points p = categories()[2].make(random, false);
        for (std::size_t k = 0; k < 4; ++k)
            p[k + 4] = p[k];
        const Vec3 v = p[0], f0 = p[1], f1 = p[2], f2 = p[3];
        // On small integers: in the plane and on one side of all edges, or,
        // where the face has no area, between two corners.
        const Vec3 normal = (f1 - f0).cross(f2 - f0);
        const auto between = [&](const Vec3& a, const Vec3& b) {
            return (a - v).cross(b - v).isZero(0) && (a - v).dot(b - v) <= 0;
        };
        const bool inside = normal.isZero(0)
                                ? between(f0, f1) || between(f1, f2) || between(f2, f0)
                                : normal.dot(v - f0) == 0 && normal.dot((f1 - f0).cross(v - f0)) >= 0 &&
                                      normal.dot((f2 - f1).cross(v - f1)) >= 0 &&
                                      normal.dot((f0 - f2).cross(v - f2)) >= 0;
        CAPTURE(i);
        const auto touch = first_touch(differences<double>(step_of<VertexFaceStep>(p)), 0.0);
        CHECK((touch.verdict == Verdict::apart) == !inside);
    }
}
