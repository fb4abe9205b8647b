#include "exercises/08_contact_by_distance/91_cone.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <cmath>
#include <utility>

using namespace enduring;

namespace {

std::vector<int> keys(const std::vector<Push>& pushes)
{
    std::vector<int> found;
    for (const Push& push : pushes)
        found.push_back(push.key);
    return found;
}

}  // namespace

TEST_CASE("vertex: the corner of a cube has the directions of one octant, and a little more with a sine")
{
    const Vec3 corner(0.4, -0.2, 0.7);
    const double size = 1.5;
    const double sine = 0.15;
    const std::vector<Vec3> edges{corner - Vec3(size, 0, 0), corner - Vec3(0, size, 0),
                                  corner - Vec3(0, 0, size)};
    RandomInputs random(81);
    int wrong = 0, wrong_with_sine = 0;
    for (int trial = 0; trial < 500; ++trial) {
        const Vec3 d = random.direction();
        wrong += in_cone(corner, edges, d, 0) != (d.minCoeff() >= 0) ? 1 : 0;
        wrong_with_sine += in_cone(corner, edges, d, sine) != (d.minCoeff() >= -sine) ? 1 : 0;
    }
    given("a cube of ", size, " m, its upper corner, 500 directions");
    expect("wrong answers without a sine", wrong, 0, 0);
    expect(in_words("wrong answers with a sine of ", sine), wrong_with_sine, 0, 0);
}

TEST_CASE("vertex: how far a neighbour is does not matter")
{
    const double far = 40.0;
    const double sine = 0.2;
    given("a neighbour that stands before the plane by a sine of 0.25, then by 0.15; the sine is ", sine);
    for (const double length : {0.01, 1.0, far}) {
        expect_that("0.25 is too much",
                    !in_cone({0, 0, 0}, {length * Vec3(std::sqrt(1 - 0.0625), 0.25, 0)}, {0, 1, 0}, sine));
        expect_that("0.15 is allowed",
                    in_cone({0, 0, 0}, {length * Vec3(std::sqrt(1 - 0.0225), 0.15, 0)}, {0, 1, 0}, sine));
    }
}

TEST_CASE(
    "edge: a roof has the directions between the normals of its sides, whatever its third corners are along it")
{
    const double steep = 0.6;
    for (const double shift : {-3.0, 0.0, 2.5}) {
        const Vec3 a(0, 0, -1), b(0, 0, 1), left(-1, -steep, shift), right(1, -steep, -shift);
        given("a roof that falls by ", steep, " on each metre, third corners shifted along it by ", shift,
              " m");
        const double most = std::atan(
            1 / steep);  // of the angle against the vertical, beyond which the sides are before the plane
        for (const double part : {0.0, 0.5, 0.9})
            for (const int side : {-1, 1}) {
                const double lean = side * part * (2 * std::atan(1.0) - most);
                expect_that(in_words("a direction that leans by ", readable(lean, 3), " lies in the cone"),
                            in_cone_of_edge(a, b, left, right, {std::sin(lean), std::cos(lean), 0}, 0));
            }
        const double beyond = 1.1 * (2 * std::atan(1.0) - most);
        expect_that("one that leans by more does not",
                    !in_cone_of_edge(a, b, left, right, {std::sin(beyond), std::cos(beyond), 0}, 0));
        const double far_beyond = 2 * std::atan(1.0) - most + 0.3;
        expect_that(
            "nor one that stands before a side by 0.3, with a sine of 0.2",
            !in_cone_of_edge(a, b, left, right, {std::sin(far_beyond), std::cos(far_beyond), 0}, 0.2));
        expect_that("one that leans along the edge does not",
                    !in_cone_of_edge(a, b, left, right, Vec3(0, 1, 0.3).normalized(), 0));
        expect_that("nor the other way",
                    !in_cone_of_edge(a, b, left, right, Vec3(0, 1, -0.3).normalized(), 0));
    }
}

TEST_CASE("edge: the bottom of a valley has no direction")
{
    const double steep = 0.4;
    RandomInputs random(82);
    int found = 0;
    for (int trial = 0; trial < 200; ++trial) {
        Vec3 d = random.direction();
        d.y() = std::abs(d.y());  // out of the ground
        found += in_cone_of_edge({0, 0, -1}, {0, 0, 1}, {-1, steep, 0}, {1, steep, 0}, d, 0) ? 1 : 0;
    }
    given("a valley that rises by ", steep, " on each metre, 200 directions out of the ground");
    expect("directions in the cone", found, 0, 0);
}

TEST_CASE("lines: of pushes along one line the first by its key is left")
{
    const double apart = 1e-4;
    const Vec3 up(0, 1, 0);
    const Push corner{7, {1, 0, 1}, up}, twin{3, {1 + apart / 2, 0.2, 1}, up},
        beside{5, {1 + 3 * apart, 0, 1}, up};
    const Push sideways{1, {1, 0, 1}, {1, 0, 0}}, other_way{9, {1, -0.3, 1}, -up};
    given(
        "pushes with the keys 7, 3, 5, 1 and 9: 7, 3 and 9 along one line, 9 the other way, 5 beside it, 1 across");
    const auto left = keys(one_of_each_line({corner, twin, beside, sideways, other_way}, apart));
    expect_that("1, 3 and 5 are left, in this order", left == std::vector{1, 3, 5});
    given("the same in another order");
    expect_that("the same are left",
                keys(one_of_each_line({other_way, beside, twin, sideways, corner}, apart)) == left);
    say(left.size(), " of 5 pushes are left");
}
