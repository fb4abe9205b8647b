#include "common/geometry/shortest_turn.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace enduring;

TEST_CASE(
    "shortest turn: it takes the one direction to the other, whatever their lengths, and leaves what lies across both")
{
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 1000; ++i) {
        const Vec3 from(normal(random), normal(random), normal(random)),
            to(normal(random), normal(random), normal(random));
        const Quaternion turn = shortest_turn(from, to);
        // near the opposite the axis is a small difference
        const double lost = 4e-16 / (1 + from.normalized().dot(to.normalized()));
        CHECK((turn * from.normalized() - to.normalized()).norm() < 1e-15 + 4 * lost);
        CHECK((turn * from.cross(to) - from.cross(to)).norm() < (1e-15 + 4 * lost) * from.norm() * to.norm());
        const double angle = std::atan2(from.cross(to).norm(), from.dot(to));
        CHECK(turn.w() == doctest::Approx(std::cos(angle / 2)).epsilon(1e-12));  // and none longer
    }
}

TEST_CASE("shortest turn: between opposite directions it is half a turn")
{
    for (const Vec3& from : {Vec3(1, 0, 0), Vec3(0, -2, 0), Vec3(1, 2, 3)})
        for (const double aside : {0.0, 1e-13, 1e-7}) {
            const Vec3 to = -from + aside * from.unitOrthogonal();
            const Quaternion turn = shortest_turn(from, to);
            CHECK(turn.norm() == doctest::Approx(1).epsilon(1e-12));
            CHECK((turn * from.normalized() - to.normalized()).norm() < 2e-7);
        }
}
