#include "chapters/05_categorisation/category.hpp"
#include "chapters/05_categorisation/experiments/corner.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace enduring;
using namespace enduring::chapter05;

namespace {

constexpr double degree = std::numbers::pi / 180;

/// The normal of a floor that leans by an angle towards a corner that looks down.
Vec3 leaning(double angle_deg) { return {-std::sin(angle_deg * degree), std::cos(angle_deg * degree), 0}; }

Corner moved(Corner corner, const Mat3& map, const Vec3& shift)
{
    for (Vec3& x : corner.positions)
        x = map * x + shift;
    return corner;
}

}  // namespace

TEST_CASE(
    "category: a corner of any opening hooks 45 degrees beyond its outermost face normal, to a millionth of a degree")
{
    for (const double opening : {20.0, 40.0, 90.0, 120.0, 160.0, 180.0})
        for (const double side : {-1.0, 1.0})
            for (const double slip : {-1e-6, 1e-6}) {
                CAPTURE(opening);
                CAPTURE(side);
                CAPTURE(slip);
                const double last = (180 - opening) / 2 + 45;
                const Corner corner = wedge_corner("wedge", opening * degree);
                CHECK(is_hooked_vertex(corner.surface(), 0, leaning(side * (last + slip))) == (slip > 0));
            }
}

TEST_CASE(
    "average: (6.1) hooks 45 degrees beyond the averaged normal, whatever the corner's opening and wherever its faces look")
{
    for (const double opening : {20.0, 40.0, 90.0, 120.0, 160.0, 180.0})
        for (const double side : {-1.0, 1.0})
            for (const double slip : {-1e-6, 1e-6}) {
                CAPTURE(opening);
                CAPTURE(side);
                CAPTURE(slip);
                const Corner corner = wedge_corner("wedge", opening * degree);
                CHECK(average_says_regular(corner, leaning(side * (45 + slip))) == (slip < 0));
            }
}

TEST_CASE(
    "average: an acute and an obtuse corner that lean alike are hooked alike by (6.1), though the acute one touches there (figure 6.6)")
{
    for (const double lean : {50.0, 60.0, 69.0}) {
        CAPTURE(lean);
        const Corner acute = wedge_corner("acute", 40 * degree),
                     obtuse = wedge_corner("obtuse", 160 * degree);
        CHECK_FALSE(average_says_regular(acute, leaning(lean)));
        CHECK_FALSE(average_says_regular(obtuse, leaning(lean)));
        CHECK(can_touch(acute, leaning(lean)));  // one of its sides is almost parallel to the floor
        CHECK_FALSE(can_touch(obtuse, leaning(lean)));
        CHECK(span_says_regular(acute, leaning(lean)));
        CHECK(span_says_regular(obtuse, leaning(lean)) == (lean < 10 + 45));
    }
}

TEST_CASE(
    "category: a vertex of a flat surface accepts the directions within 45 degrees, whichever way they lean")
{
    const Corner flat = cone_corner("flat", 6, std::numbers::pi / 2);
    for (const double turn : {0.0, 17.0, 90.0, 123.0, 260.0})
        for (const double slip : {-1e-6, 1e-6}) {
            CAPTURE(turn);
            CAPTURE(slip);
            const Vec3 normal = Eigen::AngleAxisd(turn * degree, Vec3::UnitY()) * Vec3(-leaning(45 + slip));
            CHECK(is_hooked_vertex(flat.surface(), 0, normal) == (slip > 0));
        }
    // pushed along its own normal: it is inside out
    CHECK(is_hooked_vertex(flat.surface(), 0, Vec3::UnitY()));
}

TEST_CASE("category: rotating, scaling and moving a pair together changes no label")
{
    std::mt19937_64 generator(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto direction = [&] {
        return Vec3(unit(generator), unit(generator), unit(generator)).normalized();
    };
    int hooked = 0;
    for (int i = 0; i < 500; ++i) {
        CAPTURE(i);
        std::vector<Vec3> rim;
        for (int k = 0; k < 6; ++k)
            rim.emplace_back(std::cos(k * std::numbers::pi / 3), unit(generator),
                             -std::sin(k * std::numbers::pi / 3));
        const Corner corner = fan("random", rim);
        const Vec3 normal = direction(), shift = 5 * direction();
        const Mat3 turn = Eigen::AngleAxisd(3 * unit(generator), direction()).toRotationMatrix();
        const bool label = is_hooked_vertex(corner.surface(), 0, normal);
        hooked += label;
        for (const double scale : {1e-4, 1.0, 1e3})
            CHECK(is_hooked_vertex(moved(corner, scale * turn, scale * shift).surface(), 0,
                                   scale * (turn * normal)) == label);
    }
    CHECK(hooked > 50);  // both labels were asked for
    CHECK(hooked < 450);
}

TEST_CASE(
    "category: what can touch a cube's corner is regular, all of it, and of a tetrahedron's tip all but the middle of its gaps")
{
    const std::vector<Corner> corners = sphere_corners();
    const Corner &tip = corners[0], &cube = corners[1];
    std::mt19937_64 generator(6);
    std::normal_distribution<double> normal(0, 1);
    int touching = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 direction = Vec3(normal(generator), normal(generator), normal(generator)).normalized();
        if (!can_touch(cube, direction))
            continue;
        ++touching;
        CHECK(span_says_regular(cube, direction));
    }
    CHECK(touching / 20000.0 == doctest::Approx(1.0 / 8).epsilon(0.06));
    // Between two of the tip's face normals, 109.5 degrees apart, the middle is
    // 54.7 degrees from either and from the average.
    const std::vector<Vec3> span = normal_span(tip.surface(), tip.faces());
    const Vec3 gap = -(span[0] + span[1]).normalized();
    CHECK(can_touch(tip, gap));
    CHECK_FALSE(span_says_regular(tip, gap));
}
