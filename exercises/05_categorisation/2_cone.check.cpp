#include "exercises/05_categorisation/2_cone.hpp"
#include "chapters/05_categorisation/experiments/corner.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter05 {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// The faces' normals without their average.
std::vector<Vec3> face_normals(const Corner& corner)
{
    std::vector<Vec3> normals = normal_span(corner.surface(), corner.faces());
    normals.pop_back();
    return normals;
}

/// Directions spread evenly over the sphere.
std::vector<Vec3> all_directions(int count)
{
    std::vector<Vec3> directions;
    for (int i = 0; i < count; ++i) {
        const double y = 1 - (2 * i + 1.0) / count, turn = i * std::numbers::pi * (3 - std::sqrt(5.0)),
                     r = std::sqrt(1 - y * y);
        directions.emplace_back(r * std::cos(turn), y, r * std::sin(turn));
    }
    return directions;
}

/// Three to eight directions, all within 80 degrees of one of them that is not told.
std::vector<std::vector<Vec3>> random_bundles(int count)
{
    RandomInputs random(5);
    std::vector<std::vector<Vec3>> bundles;
    for (int i = 0; i < count; ++i) {
        const Vec3 centre = random.direction();
        std::vector<Vec3> bundle;
        while (static_cast<int>(bundle.size()) < 3 + i % 6)
            if (const Vec3 one = random.direction(); one.dot(centre) > std::cos(80 * degree))
                bundle.push_back(one);
        bundles.push_back(bundle);
    }
    return bundles;
}

}  // namespace

TEST_CASE("cone: it holds all directions, and among thousands of axes none has a narrower one")
{
    const std::vector<Vec3> axes = all_directions(4000);
    for (const std::vector<Vec3>& bundle : random_bundles(30)) {
        const Cone cone = smallest_cone(bundle);
        given(bundle.size(), " random directions within 80 degrees of some axis");
        expect("length of the axis", cone.axis.norm(), 1.0, 1e-9);
        const auto widest = [&](const Vec3& axis) {
            double angle = 0;
            for (const Vec3& normal : bundle)
                angle = std::max(angle, std::atan2(axis.cross(normal).norm(), axis.dot(normal)));
            return angle / degree;
        };
        double narrowest = 180;
        for (const Vec3& axis : axes)
            narrowest = std::min(narrowest, widest(axis));
        expect("angle from its axis to the farthest of them, as the half angle says",
               cone.half_angle / degree, widest(cone.axis), 0.01, "degrees");
        expect("half angle above the narrowest that was tried",
               std::max(0.0, cone.half_angle / degree - narrowest), 0.0, 0.01, "degrees");
    }
}

TEST_CASE("cone: three directions evenly around an axis have their own angle as half angle, narrow or wide")
{
    const Mat3 turn = Eigen::AngleAxisd(2.5, Vec3(0.3, 1, -2).normalized()).toRotationMatrix();
    for (const double angle : {0.02, 1.0, 30.0, 85.0}) {
        std::vector<Vec3> around;
        for (const double phi : {10.0, 130.0, 250.0})
            around.push_back(turn * Vec3(std::sin(angle * degree) * std::cos(phi * degree),
                                         std::sin(angle * degree) * std::sin(phi * degree),
                                         std::cos(angle * degree)));
        given("three directions evenly around an axis, each ", angle, " degrees from it");
        const Cone cone = smallest_cone(around);
        expect("half angle over this angle", cone.half_angle / degree / angle, 1.0, 0.01);
        expect("axis", cone.axis, Vec3(turn.col(2)), 0.01 * angle * degree);
    }
}

TEST_CASE("cone: of one direction it is that direction, of two it is halfway between")
{
    const std::vector<Vec3> one = {Vec3(0, 0.6, 0.8)}, two = {Vec3::UnitX(), Vec3::UnitY()};
    given("one direction (0, 0.6, 0.8)");
    expect("axis", smallest_cone(one).axis, one[0], 1e-9);
    expect("half angle", smallest_cone(one).half_angle / degree, 0.0, 1e-3, "degrees");
    given("the directions of x and y");
    expect("axis", smallest_cone(two).axis, Vec3(1, 1, 0).normalized(), 1e-3);
    expect("half angle", smallest_cone(two).half_angle / degree, 45.0, 0.01, "degrees");
}

TEST_CASE("cone: at a cube's corner and at a tetrahedron's tip it touches all three normals")
{
    const Cone cube = smallest_cone(face_normals(sphere_corner("cube"))),
               tip = smallest_cone(face_normals(sphere_corner("tetrahedron")));
    given("the three normals at a cube's corner");
    expect("half angle", cube.half_angle / degree, std::acos(1 / std::sqrt(3.0)) / degree, 0.01, "degrees");
    std::vector<Vec3> backwards = face_normals(sphere_corner("cube"));
    std::reverse(backwards.begin(), backwards.end());
    given("the three normals at a cube's corner, in the opposite order");
    expect("half angle", smallest_cone(backwards).half_angle / degree, cube.half_angle / degree, 0.01,
           "degrees");
    given("the three normals at the tip of a regular tetrahedron");
    expect("half angle", tip.half_angle / degree, std::acos(1.0 / 3) / degree, 0.01, "degrees");
    say("a cube's corner: half angle ", cube.half_angle / degree,
        " degrees; a tetrahedron's tip: ", tip.half_angle / degree, " degrees");
}

TEST_CASE("cone: a direction inside it changes nothing, and three may need only two")
{
    const std::vector<Vec3> wide = {Vec3(1, 0.2, 0).normalized(), Vec3(-1, 0.2, 0).normalized(),
                                    Vec3(0, 1, 0.3).normalized()};
    given("two directions 157 degrees apart and one between them, off their plane by 17 degrees");
    const Cone cone = smallest_cone(wide);
    for (const Vec3& normal : wide)
        expect_that("no direction lies outside", std::acos(cone.axis.dot(normal)) <= cone.half_angle + 1e-4);
    expect("half angle", cone.half_angle / degree, std::acos(0.2 / std::sqrt(1.04)) / degree, 0.01,
           "degrees");
}

TEST_CASE("cone: turning the directions turns the cone")
{
    const Mat3 turn = Eigen::AngleAxisd(1.1, Vec3(1, -2, 3).normalized()).toRotationMatrix();
    const std::vector<Vec3> normals = {Vec3(1, 2, 0.5).normalized(), Vec3(-0.3, 1, 0.8).normalized(),
                                       Vec3(0.2, 1, -1).normalized(), Vec3(0.5, 1, 0).normalized()};
    std::vector<Vec3> turned;
    for (const Vec3& normal : normals)
        turned.push_back(turn * normal);
    given("four directions, and the same four turned");
    expect("axis", smallest_cone(turned).axis, Vec3(turn * smallest_cone(normals).axis), 2e-3);
    expect("half angle", smallest_cone(turned).half_angle / degree,
           smallest_cone(normals).half_angle / degree, 0.01, "degrees");
}

TEST_CASE(
    "rule: a flat vertex is regular where the contact normal looks against its own, give or take 45 degrees")
{
    const std::vector<Vec3> up(6, Vec3::UnitY());
    given("six faces that look up");
    expect_that("with a contact normal 44 degrees from down it is regular",
                cone_says_regular(up, Vec3(std::sin(44 * degree), -std::cos(44 * degree), 0)));
    expect_that("with a contact normal 46 degrees from down it is hooked",
                !cone_says_regular(up, Vec3(std::sin(46 * degree), -std::cos(46 * degree), 0)));
    expect_that("with a contact normal that looks up it is hooked", !cone_says_regular(up, Vec3::UnitY()));
}

TEST_CASE("rule: pressed on from right against its normal, a flat vertex is regular in every position")
{
    for (const Vec3& normal : all_directions(300)) {
        const std::vector<Vec3> one(1, normal);
        given("a face that looks along ", readable(normal), ", and a contact normal right against it");
        expect_that("it is regular", cone_says_regular(one, -normal));
    }
}

TEST_CASE("rule: it does not matter into how many triangles a side is cut")
{
    const std::vector<Vec3> cut = {Vec3::UnitX(), Vec3::UnitX(), Vec3::UnitX(), Vec3::UnitX(), Vec3::UnitY()};
    for (const double angle : {-88.0, 88.0}) {
        given("four faces that look along x and one along y, pressed on from ", angle,
              " degrees beside the middle of x and y");
        expect_that("it is regular", cone_says_regular(cut, Vec3(-std::cos((45 + angle) * degree),
                                                                 -std::sin((45 + angle) * degree), 0)));
    }
    for (const double angle : {-92.0, 92.0}) {
        given("four faces that look along x and one along y, pressed on from ", angle,
              " degrees beside the middle of x and y");
        expect_that("it is hooked", !cone_says_regular(cut, Vec3(-std::cos((45 + angle) * degree),
                                                                 -std::sin((45 + angle) * degree), 0)));
    }
}

TEST_CASE("rule: the half angle counts beyond the directions of a narrow edge, and 135 degrees are the most")
{
    const auto pressed = [](double angle) {
        return Vec3(-std::sin(angle * degree), -std::cos(angle * degree), 0);
    };
    for (const double half : {20.0, 80.0}) {
        const std::vector<Vec3> ridge = {Vec3(std::sin(half * degree), std::cos(half * degree), 0),
                                         Vec3(-std::sin(half * degree), std::cos(half * degree), 0)};
        given("two faces that look up, ", half, " degrees to either side");
        expect_that("pressed on from a degree less than that and 45 beside the axis it is regular",
                    cone_says_regular(ridge, pressed(half + 44)));
        expect_that("pressed on from a degree more it is hooked",
                    !cone_says_regular(ridge, pressed(half + 46)));
    }
}

TEST_CASE("rule: the 45 degrees come on top of the half angle")
{
    const std::vector<Vec3> edge = {Vec3::UnitX(), Vec3::UnitY()};
    const auto pressed = [](double angle) {
        return Vec3(-std::cos((45 + angle) * degree), -std::sin((45 + angle) * degree), 0);
    };
    given("two faces that look along x and y; their cone has a half angle of 45 degrees");
    expect_that("pressed on from 88 degrees beside the axis it is regular",
                cone_says_regular(edge, pressed(88)));
    expect_that("pressed on from 92 degrees beside the axis it is hooked",
                !cone_says_regular(edge, pressed(92)));
}

TEST_CASE("rule: at the tip of a tetrahedron no direction in which a board can touch is called hooked")
{
    const Corner tip = sphere_corner("tetrahedron");
    const std::vector<Vec3> normals = face_normals(tip);
    int touching = 0, span_misses = 0, cone_misses = 0;
    for (const Vec3& direction : all_directions(4000))
        if (can_touch(tip, direction)) {
            ++touching;
            span_misses += !span_says_regular(tip, direction);
            cone_misses += !cone_says_regular(normals, direction);
        }
    given("the tip of a tetrahedron, and the ", touching,
          " of 4000 directions in which a board can touch it");
    expect("called hooked by the cone", cone_misses, 0, 0, "directions");
    say("of the directions in which a board can touch the tip, the span misses ",
        100.0 * span_misses / touching, " %, the cone ", 100.0 * cone_misses / touching, " %");
}

}  // namespace enduring::chapter05
