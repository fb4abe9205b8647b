#include "exercises/10_self_contact/3_curvature.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <numbers>

using namespace enduring;

namespace {

constexpr double pi = std::numbers::pi;

Vec3 leaning(double angle, double around = 0)
{
    return {std::sin(angle) * std::cos(around), std::cos(angle), std::sin(angle) * std::sin(around)};
}

void expect_common_side(const std::vector<Vec3>& normals)
{
    const std::optional<Vec3> side = common_side(normals);
    expect_that("a common side is found", side.has_value());
    if (!side)
        return;
    expect("length of the direction", side->norm(), 1, 1e-9, "");
    double least = 1;
    for (const Vec3& normal : normals)
        least = std::min(least, side->dot(normal));
    expect_that(in_words("the least cosine with a normal is positive; got: ", least), least > 0);
}

/// Many normals lean to the one side by `angle`, a single one to the other.
std::vector<Vec3> one_sided(double angle)
{
    std::vector<Vec3> normals(50, leaning(angle));
    normals.push_back(leaning(-angle));
    return normals;
}

/// The border of a ramp around the y axis with radii 1 and 2, and its normals, which nearly all point up.
std::vector<Vec3> ramp_border(double turns)
{
    std::vector<Vec3> border;
    const int count = 40;
    for (int i = 0; i <= count; ++i) {
        const double angle = 2 * pi * turns * i / count;
        border.push_back({std::cos(angle), 0.2 * angle, std::sin(angle)});
    }
    for (int i = count; i >= 0; --i) {
        const double angle = 2 * pi * turns * i / count;
        border.push_back({2 * std::cos(angle), 0.2 * angle, 2 * std::sin(angle)});
    }
    return border;
}

std::vector<Vec3> ramp_normals(double turns)
{
    std::vector<Vec3> normals;
    for (int i = 0; i <= 40; ++i) {
        const double angle = 2 * pi * turns * i / 40;
        normals.push_back(Vec3(0.13 * std::sin(angle), 1, -0.13 * std::cos(angle)).normalized());
    }
    return normals;
}

const std::vector<Vec3> square = {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}};
const std::vector<Vec3> bow_tie = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}};

}  // namespace

TEST_CASE("side: normals within a cap have one")
{
    RandomInputs random(103);
    for (int trial = 0; trial < 100; ++trial) {
        const double widest = random.number(0.1, 1.3), tilt = random.number(0, 3),
                     around = random.number(0, 6);
        const Eigen::Quaterniond turn(Eigen::AngleAxisd(tilt, Vec3(std::cos(around), 0, std::sin(around))));
        std::vector<Vec3> normals;
        for (int i = 0; i < 12; ++i)
            normals.push_back(turn * leaning(random.number(0, widest), random.number(0, 2 * pi)));
        given("12 normals within ", widest, " rad of an axis");
        expect_common_side(normals);
    }
}

TEST_CASE("side: where most normals lean to one side, it is not their mean")
{
    for (const double angle : {0.9, 1.2, 1.4}) {
        given("50 normals lean by ", angle, " rad, one by as much to the other side");
        expect_common_side(one_sided(angle));
    }
}

TEST_CASE("side: normals all around have none")
{
    const auto none = [](const char* name, const std::vector<Vec3>& normals) {
        given(name);
        expect_that("no common side is found", !common_side(normals).has_value());
    };
    none("a normal and its opposite", {{0, 1, 0}, {0, -1, 0}});
    none("three normals of a prism", {leaning(0), leaning(2 * pi / 3), leaning(-2 * pi / 3)});
    none("the normals of a tetrahedron", {Vec3(1, 1, 1).normalized(), Vec3(1, -1, -1).normalized(),
                                          Vec3(-1, 1, -1).normalized(), Vec3(-1, -1, 1).normalized()});
}

TEST_CASE("border: a polygon does not cross itself, a bow tie does, from either side")
{
    for (const double side : {1.0, -1.0}) {
        given("seen along y times ", side);
        expect_that("a square does not cross itself", !border_crosses_itself(square, {0, side, 0}));
        expect_that("a bow tie crosses itself", border_crosses_itself(bow_tie, {0, side, 0}));
    }
    std::vector<Vec3> lifted = bow_tie;
    lifted[2].y() = 5;
    given("a bow tie with a corner 5 m above the others");
    expect_that("it crosses itself, seen along y", border_crosses_itself(lifted, {0, 1, 0}));
}

TEST_CASE("border: its last edge counts")
{
    given("six corners; only the edge from the last to the first crosses another one");
    expect_that(
        "it crosses itself",
        border_crosses_itself({{0, 0, 0}, {4, 0, 0}, {4, 0, 3}, {2, 0, 3}, {2, 0, 1}, {3, 0, 2}}, {0, 1, 0}));
    given("the same with the last corner on the other side");
    expect_that("it does not cross itself",
                !border_crosses_itself({{0, 0, 0}, {4, 0, 0}, {4, 0, 3}, {2, 0, 3}, {2, 0, 1}, {1, 0, 2}},
                                       {0, 1, 0}));
}

TEST_CASE("touch: flat pieces cannot, folded ones may, and neither may a ramp that comes round over itself")
{
    const auto told = [](bool may) { return may ? ", may touch itself" : ", may not touch itself"; };
    given("a flat square");
    expect_that("it cannot touch itself", !may_touch_itself({{0, 1, 0}, {0, 1, 0}}, square));
    given("a square folded onto itself");
    expect_that("it may touch itself", may_touch_itself({{0, 1, 0}, {0, -1, 0}}, square));
    given("half a turn of a ramp");
    expect_that("it cannot touch itself", !may_touch_itself(ramp_normals(0.5), ramp_border(0.5)));
    given("a ramp of one and a quarter turns");
    expect_that("it may touch itself", may_touch_itself(ramp_normals(1.25), ramp_border(1.25)));
    say("a leaf with most normals on one side: ",
        common_side(one_sided(1.2)) ? "has a common side" : "has none",
        told(may_touch_itself(one_sided(1.2), square)));
    say("a spiral ramp: ", common_side(ramp_normals(1.25)) ? "has a common side" : "has none",
        told(may_touch_itself(ramp_normals(1.25), ramp_border(1.25))));
}
