#include "common/simulation/surface_axes.hpp"

#include <Eigen/Geometry>

#include <doctest/doctest.h>

using namespace enduring;

TEST_CASE("surface axes: they are orthonormal, right-handed, and lie alike towards both sides")
{
    const Vec3 one(2, 0.1, -0.3), other(0.4, 0.2, 5);
    const std::optional<Mat3> axes = surface_axes(one, other), exchanged = surface_axes(other, one);
    REQUIRE(axes);
    REQUIRE(exchanged);
    CHECK((axes->transpose() * *axes - Mat3::Identity()).norm() < 1e-15);
    CHECK(axes->determinant() == doctest::Approx(1));
    CHECK(axes->col(1).dot(one.cross(other)) == doctest::Approx(one.cross(other).norm()));
    CHECK(axes->col(0).dot(one.normalized()) == doctest::Approx(axes->col(0).dot(other.normalized())));
    CHECK((axes->col(0) - exchanged->col(0)).norm() < 1e-15);
    CHECK((axes->col(1) + exchanged->col(1)).norm() < 1e-15);
}

TEST_CASE("surface axes: they turn with the sides, and lengths of sides have no part in them")
{
    const Vec3 one(2, 0.1, -0.3), other(0.4, 0.2, 5);
    const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()).toRotationMatrix();
    const std::optional<Mat3> axes = surface_axes(one, other),
                              turned = surface_axes(1e-6 * (turn * one), 1e6 * (turn * other));
    REQUIRE(axes);
    REQUIRE(turned);
    CHECK((*turned - turn * *axes).norm() < 1e-14);
}

TEST_CASE("surface axes: parallel sides, and a side of length zero, have none")
{
    CHECK(!surface_axes(Vec3(1, 2, 3), Vec3(2, 4, 6)));
    CHECK(!surface_axes(Vec3(1, 0, 0), Vec3(-3, 0, 0)));
    CHECK(!surface_axes(Vec3(1, 0, 0), Vec3::Zero()));
}
