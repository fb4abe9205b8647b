#include "common/geometry/closest_points.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace enduring;

namespace {

class Points {
public:
    Vec3 operator()() { return {number_(engine_), number_(engine_), number_(engine_)}; }

private:
    std::mt19937_64 engine_{4};
    std::uniform_real_distribution<double> number_{-1, 1};
};

/// The smallest distance over a fine grid of weights.
double by_brute_force(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
    constexpr int cells = 200;
    double least = INFINITY;
    for (int i = 0; i <= cells; ++i)
        for (int j = 0; i + j <= cells; ++j) {
            const double u = double(i) / cells, v = double(j) / cells;
            least = std::min(least, (p - a - u * (b - a) - v * (c - a)).norm());
        }
    return least;
}

}  // namespace

TEST_CASE(
    "closest points: no point of a triangle is nearer than the one that is told, and one of a fine grid hardly farther")
{
    Points random;
    for (int i = 0; i < 200; ++i) {
        const Vec3 a = random(), b = random(), p = 2 * random();
        const Vec3 c = i % 5 == 0 ? Vec3(0.3 * a + 0.7 * b) : i % 7 == 0 ? a : random();  // also without area
        const ClosestOnTriangle closest = closest_on_triangle(p, a, b, c);
        const double searched = by_brute_force(p, a, b, c);
        CAPTURE(i);
        CHECK(closest.distance <= searched + 1e-12);
        CHECK(closest.distance >= searched - 0.02);
        CHECK(closest.weights[0] + closest.weights[1] + closest.weights[2] == doctest::Approx(1));
        CHECK((closest.weights[0] * a + closest.weights[1] * b + closest.weights[2] * c - closest.point)
                  .norm() < 1e-14);
        CHECK((p - closest.point).norm() == doctest::Approx(closest.distance));
    }
}

TEST_CASE("closest points: beyond a side or a corner of a triangle the other weights are exactly zero")
{
    const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
    const auto weights = [&](const Vec3& p) { return closest_on_triangle(p, a, b, c).weights; };
    CHECK(weights({0.3, -1, 0.5}) == std::array<double, 3>{0.7, 0.3, 0});
    CHECK(weights({-1, -1, 0.2}) == std::array<double, 3>{1, 0, 0});
    CHECK(weights({3, 0.1, 0}) == std::array<double, 3>{0, 1, 0});
    CHECK(closest_on_triangle({0.25, 0.25, -2}, a, b, c).distance == 2);
}

TEST_CASE("closest points: of two edges they stand at right angles to both, or there are none")
{
    Points random;
    int found = 0;
    for (int i = 0; i < 500; ++i) {
        const Vec3 a0 = random(), a1 = random(), b0 = random(), b1 = random();
        const auto closest = closest_inside_edges(a0, a1, b0, b1, 1e-3);
        CAPTURE(i);
        double ends = INFINITY, least = INFINITY;  // by brute force: from the ends, and from anywhere
        for (int k = 0; k <= 100; ++k)
            for (int m = 0; m <= 100; ++m) {
                const double s = k / 100.0, t = m / 100.0,
                             d = (a0 + s * (a1 - a0) - b0 - t * (b1 - b0)).norm();
                least = std::min(least, d);
                if (k % 100 == 0 || m % 100 == 0)
                    ends = std::min(ends, d);
            }
        if (!closest) {
            CHECK(ends <= least + 0.02);
            continue;
        }
        ++found;
        CHECK(std::abs(closest->difference.dot(a1 - a0)) < 1e-9);
        CHECK(std::abs(closest->difference.dot(b1 - b0)) < 1e-9);
        CHECK((a0 + closest->s * (a1 - a0) - b0 - closest->t * (b1 - b0) - closest->difference).norm() <
              1e-12);
        CHECK(closest->difference.norm() <= least + 1e-12);
    }
    CHECK(found > 50);
    CHECK_FALSE(closest_inside_edges({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1e-4}, 1e-3));
}
