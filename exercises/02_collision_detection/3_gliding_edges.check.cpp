#include "exercises/02_collision_detection/3_gliding_edges.hpp"
#include "chapters/02_collision_detection/certified.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

using namespace enduring;

namespace {

struct Case {
    Vec3 a0, a1, way, b0, b1;

    std::optional<double> answer() const { return first_touch_of_gliding_edge(a0, a1, way, b0, b1); }
    std::optional<double> certified() const
    {
        return time_of_impact(EdgeEdgeStep{a0, a1, b0, b1, a0 + way, a1 + way, b0, b1});
    }
};

std::string name_of(const Case& c)
{
    return "a from " + readable(c.a0) + " to " + readable(c.a1) + " glides by " + readable(c.way) +
           "; b from " + readable(c.b0) + " to " + readable(c.b1) + " m";
}

std::string told(const std::optional<double>& time)
{
    return time ? "tau = " + readable(*time) : std::string("no touch");
}

bool same(const std::optional<double>& a, const std::optional<double>& b)
{
    return a.has_value() == b.has_value() && (!a || std::abs(*a - *b) < 1e-9);
}

void expect_touch(const Case& c, std::optional<double> expected)
{
    given(name_of(c));
    const std::optional<double> got = c.answer();
    expect_that(told(expected) + "; your answer: " + told(got), same(got, expected));
}

/// Small whole coordinates: edges touch at corners and slide in one plane far more often than chance would
/// have it, and all products are exact.
std::vector<Case> random_cases(int count, int spread)
{
    RandomInputs random(7);
    const auto point = [&] {
        const int x = random.whole(-spread, spread), y = random.whole(-spread, spread),
                  z = random.whole(-spread, spread);
        return Vec3(x, y, z);
    };
    std::vector<Case> cases;
    while (static_cast<int>(cases.size()) < count) {
        const Vec3 a0 = point(), a1 = point(), way = point(), b0 = point(), b1 = point();
        if (a0 != a1 && b0 != b1)
            cases.push_back({a0, a1, way, b0, b1});
    }
    return cases;
}

/// Edge a, along x, moves from one height to another; edge b lies along z at height 0. Both are 2 m long.
Case crossing(double height_t0, double height_t1, double shift_of_a = 0, double shift_of_b = 0)
{
    return {Vec3(-1 + shift_of_a, height_t0, 0), Vec3(1 + shift_of_a, height_t0, 0),
            Vec3(0, height_t1 - height_t0, 0), Vec3(0, 0, -1 + shift_of_b), Vec3(0, 0, 1 + shift_of_b)};
}

}  // namespace

TEST_CASE("times: a value that rises is between its bounds from the lower to the upper one")
{
    const Times times = when_between({0, 1}, -1, 4, 0, 2);
    given("-1 + 4 tau between 0 and 2, in [0, 1]");
    expect("first", times.first, 0.25, 1e-15);
    expect("last", times.last, 0.75, 1e-15);
}

TEST_CASE("times: a value that falls is between its bounds from the upper to the lower one")
{
    const Times times = when_between({0, 1}, 3, -4, 0, 2);
    given("3 - 4 tau between 0 and 2, in [0, 1]");
    expect("first", times.first, 0.25, 1e-15);
    expect("last", times.last, 0.75, 1e-15);
}

TEST_CASE("times: a value that stays leaves all of the times or none")
{
    const Times inside = when_between({0.25, 0.5}, 1, 0, 0, 1),
                outside = when_between({0.25, 0.5}, 2, 0, 0, 1);
    given("1 and 2 between 0 and 1, in [0.25, 0.5]");
    expect("first, for 1", inside.first, 0.25, 0);
    expect("last, for 1", inside.last, 0.5, 0);
    expect_that("for 2 there is no time left", outside.empty());
}

TEST_CASE("crossing: edges that fall through each other touch when the height is zero")
{
    expect_touch(crossing(3, -1), 0.75);
    expect_touch(crossing(-1, 3), 0.25);
}

TEST_CASE("crossing: a touch before or after the step is none")
{
    expect_touch(crossing(3, 1), std::nullopt);
    expect_touch(crossing(1, 3), std::nullopt);
}

TEST_CASE("crossing: lines that meet beside an edge are no touch, and its end belongs to it")
{
    expect_touch(crossing(3, -1, 1.5), std::nullopt);
    expect_touch(crossing(3, -1, 0, 1.5), std::nullopt);
    expect_touch(crossing(3, -1, 1), 0.75);
    expect_touch(crossing(3, -1, 0, -1), 0.75);
}

TEST_CASE("one plane: an edge that slides over the floor meets another that lies there")
{
    // a lies along z and moves along x; b lies along x, from 2 on.
    expect_touch({Vec3(0, 0, -1), Vec3(0, 0, 1), Vec3(4, 0, 0), Vec3(2, 0, 0.5), Vec3(5, 0, 0.5)}, 0.5);
    expect_touch({Vec3(0, 0, -1), Vec3(0, 0, 1), Vec3(4, 0, 0), Vec3(2, 0, 1.5), Vec3(5, 0, 1.5)},
                 std::nullopt);
    expect_touch({Vec3(0, 1, -1), Vec3(0, 1, 1), Vec3(4, 0, 0), Vec3(2, 0, 0.5), Vec3(5, 0, 0.5)},
                 std::nullopt);
}

TEST_CASE("one plane: edges that cross at the start touch at once")
{
    expect_touch({Vec3(-1, 0, -1), Vec3(1, 0, 1), Vec3(3, 0, 0), Vec3(-1, 0, 1), Vec3(1, 0, -1)}, 0.0);
}

TEST_CASE("parallel: an edge that comes down on a parallel one touches where they lie side by side")
{
    expect_touch({Vec3(0, 3, 0), Vec3(2, 3, 0), Vec3(0, -4, 0), Vec3(1, 0, 0), Vec3(5, 0, 0)}, 0.75);
    expect_touch({Vec3(0, 3, 0), Vec3(2, 3, 0), Vec3(0, -4, 0), Vec3(3, 0, 0), Vec3(5, 0, 0)}, std::nullopt);
    expect_touch({Vec3(0, 3, 0), Vec3(2, 3, 0), Vec3(0, -4, 1), Vec3(1, 0, 0), Vec3(5, 0, 0)}, std::nullopt);
}

TEST_CASE("parallel: it does not matter which way each of them points")
{
    expect_touch({Vec3(0, 3, 0), Vec3(2, 3, 0), Vec3(0, -4, 0), Vec3(5, 0, 0), Vec3(1, 0, 0)}, 0.75);
    expect_touch({Vec3(2, 3, 0), Vec3(0, 3, 0), Vec3(0, -4, 0), Vec3(1, 0, 0), Vec3(5, 0, 0)}, 0.75);
}

TEST_CASE("parallel: edges that are only nearly parallel cross in one point")
{
    // Both 2000 m long; b leaves a's direction by 1/1000, or less, to both sides of its middle.
    for (const double aside : {100.0, 10.0, 1.0}) {
        expect_touch({Vec3(-1000, 3, 0), Vec3(1000, 3, 0), Vec3(0, -4, 0), Vec3(-1000, 0, -aside),
                      Vec3(1000, 0, aside)},
                     0.75);
        expect_touch({Vec3(-1000, 3, 2 * aside), Vec3(1000, 3, 2 * aside), Vec3(0, -4, 0),
                      Vec3(-1000, 0, -aside), Vec3(1000, 0, aside)},
                     std::nullopt);
    }
}

TEST_CASE("size: millimetres and kilometres have the same times")
{
    for (const double size :
         {0x1p-20, 0x1p-10, 1.0, 0x1p10}) {  // powers of two, so that all products stay exact
        const auto sized = [&](const Case& c) {
            return Case{size * c.a0, size * c.a1, size * c.way, size * c.b0, size * c.b1};
        };
        expect_touch(sized(crossing(3, -1)), 0.75);
        expect_touch(sized(crossing(3, -1, 1.5)), std::nullopt);
        expect_touch(sized({Vec3(0, 3, 0), Vec3(2, 3, 0), Vec3(0, -4, 0), Vec3(1, 0, 0), Vec3(5, 0, 0)}),
                     0.75);
        expect_touch(sized({Vec3(0, 3, 1), Vec3(2, 3, 1), Vec3(0, -4, 0), Vec3(1, 0, 0), Vec3(5, 0, 0)}),
                     std::nullopt);
    }
}

TEST_CASE("one line: an edge that slides along its own line runs into the other")
{
    expect_touch({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(4, 0, 0), Vec3(3, 0, 0), Vec3(6, 0, 0)}, 0.5);
    expect_touch({Vec3(8, 0, 0), Vec3(9, 0, 0), Vec3(-4, 0, 0), Vec3(3, 0, 0), Vec3(6, 0, 0)}, 0.5);
    expect_touch({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 0, 0), Vec3(3, 0, 0), Vec3(6, 0, 0)}, std::nullopt);
}

TEST_CASE("oracle: the chapter's certified query says the same, for whole coordinates of any kind")
{
    int wrong = 0;
    for (const int spread : {1, 5}) {
        int touching = 0, in_one_plane = 0, parallel = 0;
        const std::vector<Case> cases = random_cases(20000, spread);
        for (const Case& c : cases) {
            const std::optional<double> expected = c.certified(), got = c.answer();
            const Vec3 normal = (c.a1 - c.a0).cross(c.b1 - c.b0);
            touching += expected.has_value();
            parallel += expected && normal.norm() == 0;
            in_one_plane += expected && normal.norm() > 0 && normal.dot(c.way) == 0;
            if (wrong < 3 && !same(expected, got)) {
                ++wrong;
                expect_touch(c, expected);
            }
        }
        say(cases.size(), " pairs of edges, coordinates up to ", spread, ": ", touching, " touch; of these ",
            in_one_plane, " slide in one plane, ", parallel, " are parallel");
    }
}
