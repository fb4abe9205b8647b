#include "common/geometry/triangle_foot.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace enduring;

TEST_CASE(
    "triangle foot: the weights give the foot, the depth the way back to the point, on either side and beyond the edges")
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-1, 1);
    const auto point = [&] { return Vec3(number(random), number(random), number(random)); };
    for (int i = 0; i < 200; ++i) {
        const Vec3 a = point(), b = point(), c = point(), p = 2 * point();
        const Vec3 normal = (b - a).cross(c - a);
        if (normal.norm() < 0.05)
            continue;
        const auto foot = foot_on_triangle(p, a, b, c);
        REQUIRE(foot.has_value());
        const auto& w = foot->weights;
        CHECK(w[0] + w[1] + w[2] == doctest::Approx(1));
        CHECK((w[0] * a + w[1] * b + w[2] * c + foot->depth * normal.normalized() - p).norm() < 1e-11);
    }
}

TEST_CASE("triangle foot: a triangle without area has none")
{
    CHECK_FALSE(foot_on_triangle({0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {3, 0, 0}).has_value());
    CHECK_FALSE(foot_on_triangle({0, 1, 0}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}).has_value());
}

TEST_CASE("lerp: it is exact at both ends, for numbers of very different size")
{
    const Vec3 start(1e16, 0.1, -3), end(1, 0.3, 1e-16);
    CHECK(lerp(start, end, 0) == start);
    CHECK(lerp(start, end, 1) == end);
    CHECK((lerp({0, 2, 4}, {1, 0, 4}, 0.25) - Vec3(0.25, 1.5, 4)).norm() < 1e-15);
}
