#include "chapters/08_contact_by_distance/sliding_normal.hpp"
#include "chapters/08_contact_by_distance/tests/moving_surface.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

using namespace enduring;
using namespace enduring::chapter08;

namespace {

/// In the plane of x and y, leaning from y towards -x by an angle, as the walls of a hollow do further along
/// x.
Vec3 leaning(double angle) { return {-std::sin(angle), std::cos(angle), 0}; }

/// Along x, diving by an angle.
Vec3 diving(double angle) { return {std::cos(angle), -std::sin(angle), 0}; }

}  // namespace

TEST_CASE(
    "sliding normal: what comes along a surface that bends is at right angles to it, at any size and direction")
{
    Draw draw(3);
    for (const double scale : {1e-5, 1.0, 100.0})
        for (const double bend : {1e-3, 0.05, 0.4})
            for (const double part : {0.0, 0.3, 0.7, 0.99}) {
                const Quaternion turn = draw.turn();
                const Vec3 motion =
                    scale * diving(std::atan2(part * std::sin(bend), 1 + part * (1 - std::cos(bend))));
                const Vec3 found = turn.inverse() *
                                   sliding_normal(turn * leaning(0), turn * leaning(bend), turn * motion);
                CAPTURE(bend);
                CAPTURE(part);
                REQUIRE(found.norm() == doctest::Approx(1));
                CHECK(std::abs(found.dot(motion.normalized())) < 1e-12);
                CHECK(found.x() >= -1e-12);  // away from the end's normal
            }
}

TEST_CASE("sliding normal: what rises a little came along the surface of the start")
{
    for (const double bend : {0.3, -0.3}) {
        const Vec3 found = sliding_normal(leaning(0), leaning(bend), diving(bend > 0 ? -0.1 : 0.1));
        CHECK((found - leaning(0)).norm() < 1e-12);
    }
}

TEST_CASE("sliding normal: there is none on flat ground, for what hits the surface, and over a sharp corner")
{
    CHECK(sliding_normal(leaning(0.2), leaning(0.2), diving(0)).isZero(0));
    CHECK(sliding_normal(leaning(0.2), leaning(0.2), diving(0.3)).isZero(0));
    for (const double dive : {0.12, 1.0, 1.5})
        CHECK(sliding_normal(leaning(0), leaning(0.1), diving(dive)).isZero(0));
    CHECK(sliding_normal(leaning(0), leaning(0.9), diving(0)).isZero(0));
    CHECK(sliding_normal(Vec3::Zero(), leaning(0.1), diving(0)).isZero(0));
}
