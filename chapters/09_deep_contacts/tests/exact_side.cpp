#include "chapters/09_deep_contacts/piercing.hpp"

#include <doctest/doctest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <cmath>
#include <random>

using namespace enduring;

namespace {

int side(const Vec3& x, const Vec3& v, const Vec3& w, int shift)
{
    const Vec3 zero = Vec3::Zero();
    return side_of_plane({x, zero}, {v, zero}, {w, zero}, shift);
}

}  // namespace

TEST_CASE(
    "exact side: small whole numbers give the sign of their determinant, with no shift where it is zero")
{
    std::mt19937_64 random(8);
    std::uniform_int_distribution<int> digit(-3, 3);
    const auto vector = [&] {
        const int x = digit(random), y = digit(random), z = digit(random);
        return Vec3(x, y, z);
    };
    int zeros = 0;
    for (int i = 0; i < 5000; ++i) {
        const Vec3 x = vector(), v = vector(), w = vector(), cross = v.cross(w);
        const double determinant = x.dot(cross);  // exact: small whole numbers
        CAPTURE(x.transpose());
        CAPTURE(v.transpose());
        CAPTURE(w.transpose());
        CHECK(side(x, v, w, 0) == (determinant > 0) - (determinant < 0));
        // A shift of a thousandth and its powers moves no determinant past zero that is not zero.
        const double shifted = (x + Vec3(1e-3, 1e-6, 1e-9)).dot(cross);
        CHECK(side(x, v, w, 1) == (shifted > 0) - (shifted < 0));
        zeros += determinant == 0;
    }
    CHECK(zeros > 200);
}

TEST_CASE("exact side: a point one last digit above a plane is above it, whatever the plane's direction")
{
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> unit(0.5, 1);
    for (int i = 0; i < 300; ++i) {
        const double a = unit(random), b = unit(random), c = unit(random), d = unit(random);
        // y = x is in the plane of (1, 1, c) and (a, a, b) exactly; one digit more is beside it.
        const Vec3 v(a, a, b), w(c, c, d), in(d, d, a), beside(d, std::nextafter(d, 2.0), a);
        const Vec3 normal(1, -1, 0);
        const int facing = a * d - b * c > 0 ? 1 : -1;  // v x w = (a d - b c) (1, -1, 0)
        CHECK(side(in, v, w, 0) == 0);
        CHECK(side(in, v, w, 1) == facing);
        CHECK(side(in, v, w, -1) == -facing);
        CHECK(side(beside, v, w, 0) == -facing);
        CHECK(side(beside, v, w, 1) == -facing);
    }
}

TEST_CASE("exact side: next to a plane it is the sign of the exact determinant, where doubles have another")
{
    using Rational = boost::multiprecision::cpp_rational;
    std::mt19937_64 random(10);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto vector = [&] {
        const double x = unit(random), y = unit(random), z = unit(random);
        return Vec3(x, y, z);
    };
    const auto term = [](double a, double b, double c) { return Rational(a) * Rational(b) * Rational(c); };
    int doubles_wrong = 0;
    for (int i = 0; i < 1000; ++i) {
        const Vec3 v = vector(), w = vector(), x = unit(random) * v + unit(random) * w;
        const Rational determinant = term(x.x(), v.y(), w.z()) - term(x.x(), v.z(), w.y()) +
                                     term(x.y(), v.z(), w.x()) - term(x.y(), v.x(), w.z()) +
                                     term(x.z(), v.x(), w.y()) - term(x.z(), v.y(), w.x());
        CHECK(side(x, v, w, 0) == determinant.sign());
        const double rounded = x.dot(v.cross(w));
        doubles_wrong += (rounded > 0) - (rounded < 0) != determinant.sign();
    }
    CHECK(doubles_wrong > 50);
}
