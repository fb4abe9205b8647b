#include "chapters/01_particle_plane/plane_impulse.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace enduring;

namespace {

struct RandomSteps {
    std::mt19937 random{11};
    std::uniform_real_distribution<double> depth{-0.5, 0.5}, stiffness{1, 1e5}, step{1e-4, 0.2};
};

/// Integral of max(0, -depth) over the step, by its antiderivative: where the depth runs with slope s from a
/// to b, the integral of its negative part is (min(a,0)^2 - min(b,0)^2) / (2 s).
double negative_part(double a, double b)
{
    if (a == b)
        return a < 0 ? -a : 0;
    const double low = std::min(a, 0.0), high = std::min(b, 0.0);
    return (low * low - high * high) / (2 * (b - a));
}

}  // namespace

TEST_CASE("plane interval: a vertex is inside exactly between the crossings of its straight way")
{
    CHECK_FALSE(find_plane_interval(0.1, 0.2));
    CHECK_FALSE(find_plane_interval(0.0, 0.2));
    CHECK_FALSE(find_plane_interval(0.0, 0.0));
    const auto check = [](double depth_t0, double depth_t1, double begin, double end) {
        CAPTURE(depth_t0);
        CAPTURE(depth_t1);
        const auto inside = find_plane_interval(depth_t0, depth_t1);
        REQUIRE(inside);
        CHECK(inside->begin == doctest::Approx(begin));
        CHECK(inside->end == doctest::Approx(end));
    };
    check(-0.1, -0.2, 0, 1);
    check(0.3, -0.1, 0.75, 1);
    check(-0.1, 0.3, 0, 0.25);
    check(0.0, -0.1, 0, 1);
    check(-0.1, 0.0, 0, 1);
}

TEST_CASE("plane impulses: the continuous one is k dt times the integral of the negative part of the depth")
{
    RandomSteps any;
    for (int i = 0; i < 10000; ++i) {
        const double a = any.depth(any.random), b = any.depth(any.random), k = any.stiffness(any.random),
                     dt = any.step(any.random);
        CAPTURE(a);
        CAPTURE(b);
        const double expected = k * dt * negative_part(a, b);
        CHECK(std::abs(continuous_plane_impulse(a, b, k, dt) - expected) <= 1e-14 * k * dt);
    }
}

TEST_CASE("plane impulses: going in, the discrete one is the larger, and coming out the smaller")
{
    RandomSteps any;
    for (int i = 0; i < 1000; ++i) {
        double a = any.depth(any.random), b = any.depth(any.random);
        if (a < b)
            std::swap(a, b);  // from a down to b
        if (b >= 0)
            continue;
        CAPTURE(a);
        CAPTURE(b);
        CHECK(discrete_plane_impulse(b, 1000, 0.01) > continuous_plane_impulse(a, b, 1000, 0.01));
        CHECK(discrete_plane_impulse(a, 1000, 0.01) < continuous_plane_impulse(b, a, 1000, 0.01));
    }
}

TEST_CASE("plane impulses: at constant depth both methods are the force times the step")
{
    CHECK(discrete_plane_impulse(-0.02, 300, 0.1) == doctest::Approx(0.6));
    CHECK(continuous_plane_impulse(-0.02, -0.02, 300, 0.1) == doctest::Approx(0.6));
}

TEST_CASE("plane impulses: the ground never pulls")
{
    RandomSteps any;
    for (int i = 0; i < 1000; ++i) {
        const double a = any.depth(any.random), b = any.depth(any.random);
        CHECK(discrete_plane_impulse(b, 1000, 0.01) >= 0);
        CHECK(continuous_plane_impulse(a, b, 1000, 0.01) >= 0);
    }
    CHECK(discrete_plane_impulse(0.1, 1000, 0.01) == 0);
    CHECK(continuous_plane_impulse(0.1, 0.0, 1000, 0.01) == 0);
}

TEST_CASE("plane impulses: the continuous one is the limit of many discrete ones along the way")
{
    const double a = 0.03, b = -0.05, k = 700, dt = 0.02;
    const double exact = continuous_plane_impulse(a, b, k, dt);
    double last_error = 1;
    for (const int parts : {10, 100, 1000}) {
        double sum = 0;
        for (int i = 1; i <= parts; ++i)
            sum += discrete_plane_impulse(a + (b - a) * i / parts, k, dt / parts);
        CHECK(std::abs(sum - exact) < 0.15 * last_error);
        last_error = std::abs(sum - exact);
    }
}
