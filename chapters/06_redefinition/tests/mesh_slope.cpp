#include "chapters/06_redefinition/experiments/mesh_slope.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace enduring;
using namespace enduring::chapter06;

TEST_CASE("mesh slope: on triangles at 10 degrees the block holds with 1.05 tan, and slides with 0.95 tan")
{
    const double tangent = std::tan(std::numbers::pi / 18);
    CHECK(holds({10, 0.01, 1.05 * tangent, 0.5 * tangent}));
    CHECK(!holds({10, 0.01, 0.95 * tangent, 0.475 * tangent}));
}

TEST_CASE("mesh slope: on triangles the block slides with g (sin - mu_d cos) to a hundredth")
{
    for (const double angle : {10.0, 30.0}) {
        CAPTURE(angle);
        const double a = angle * std::numbers::pi / 180, mu_d = 0.4 * std::tan(a);
        CHECK(slide_acceleration(angle, 0.01, mu_d) ==
              doctest::Approx(9.81 * (std::sin(a) - mu_d * std::cos(a))).epsilon(0.01));
    }
}
