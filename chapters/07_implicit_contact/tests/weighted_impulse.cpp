#include "chapters/07_implicit_contact/weighted_impulse.hpp"

#include "chapters/01_particle_plane/plane_impulse.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace enduring;

namespace {

struct Way {
    double depth_t0, depth_t1;
};
const Way ways[] = {{-0.03, -0.01}, {0.02, -0.05}, {-0.04, 0.013}, {-0.01, -0.07},
                    {0.5, -1e-6},   {0.02, 0.01},  {-0.02, -0.02}};
constexpr double k = 700, dt = 0.02;

/// Sum over many short pieces of the step, each with its weight.
double summed(const Way& way, double centre)
{
    const double p = centre / (1 - centre);
    const int pieces = 200000;
    double sum = 0;
    for (int i = 0; i < pieces; ++i) {
        const double tau = (i + 0.5) / pieces, depth = way.depth_t0 + tau * (way.depth_t1 - way.depth_t0);
        sum += p * std::pow(tau, p - 1) * std::min(0.0, depth) / pieces;
    }
    return -k * dt * sum;
}

}  // namespace

TEST_CASE("weighted impulse: it is the force summed along the way, each moment with its weight")
{
    for (const Way& way : ways)
        for (const double centre : {0.5, 0.6, 2.0 / 3, 0.9}) {
            CAPTURE(way.depth_t0);
            CAPTURE(way.depth_t1);
            CAPTURE(centre);
            CHECK(std::abs(weighted_impulse(way.depth_t0, way.depth_t1, centre, k, dt).impulse -
                           summed(way, centre)) <= 1e-6);
        }
}

TEST_CASE(
    "weighted impulse: with its centre in the middle it is chapter 1's continuous one, at the end the discrete one")
{
    for (const auto& [depth_t0, depth_t1] : ways) {
        CHECK(weighted_impulse(depth_t0, depth_t1, 0.5, k, dt).impulse ==
              doctest::Approx(continuous_plane_impulse(depth_t0, depth_t1, k, dt)).epsilon(1e-9));
        CHECK(weighted_impulse(depth_t0, depth_t1, 1, k, dt).impulse ==
              doctest::Approx(discrete_plane_impulse(depth_t1, k, dt)).epsilon(1e-9));
    }
}

TEST_CASE("weighted impulse: its slope is that of its differences, and never positive")
{
    for (const auto& [depth_t0, depth_t1] : ways)
        for (const double centre : {0.5, 2.0 / 3, 1.0}) {
            const double step = 1e-7;
            const double above = weighted_impulse(depth_t0, depth_t1 + step, centre, k, dt).impulse;
            const double below = weighted_impulse(depth_t0, depth_t1 - step, centre, k, dt).impulse;
            const double slope = weighted_impulse(depth_t0, depth_t1, centre, k, dt).slope;
            CHECK(slope <= 0);
            CHECK(std::abs(slope - (above - below) / (2 * step)) <= 1e-5 * k * dt);
        }
}
