#include "exercises/09_deep_contacts/3_separation_direction.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <algorithm>

using namespace enduring;

namespace {

RandomInputs generator(83);

Vec3 random_vector() { return generator.point(-1, 1); }

Loop random_loop(int points)
{
    Loop loop;
    for (int i = 0; i < points; ++i)
        loop.push_back(random_vector());
    return loop;
}

Loop moved(Loop loop, const Vec3& by)
{
    for (Vec3& point : loop)
        point += by;
    return loop;
}

Loop scaled(Loop loop, double size)
{
    for (Vec3& point : loop)
        point *= size;
    return loop;
}

/// A square of 1 m in the plane z = 0 that looks upwards along z.
const Loop tile{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

/// Where the surface of a cube of 1 m at the origin enters a cube that begins at (a, a, a).
Loop around_a_corner(double a) { return {{1, a, a}, {1, 1, a}, {a, 1, a}, {a, 1, 1}, {a, a, 1}, {1, a, 1}}; }

/// Integrals over a surface of triangles between the loop and some random point: of the normals, and of
/// (x - centre) cross normal.
std::pair<Vec3, Vec3> over_a_surface(const Loop& loop, const Vec3& apex, const Vec3& centre)
{
    Vec3 normals = Vec3::Zero(), moments = Vec3::Zero();
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec3 &p = loop[i], &q = loop[(i + 1) % loop.size()];
        const Vec3 area = (p - apex).cross(q - apex) / 2;
        normals += area;
        moments += ((apex + p + q) / 3 - centre).cross(area);
    }
    return {normals, moments};
}

}  // namespace

TEST_CASE("area: a square that looks upwards has its size, upwards")
{
    given("a square of 1 m, its corners anticlockwise seen from z");
    expect("vector area", vector_area(tile), Vec3(0, 0, 1), 1e-15, "m^2");
    const Loop backwards(tile.rbegin(), tile.rend());
    given("the same square, its corners clockwise");
    expect("vector area", vector_area(backwards), Vec3(0, 0, -1), 1e-15, "m^2");
}

TEST_CASE("area: it is that of any surface with this border")
{
    for (int points = 3; points < 12; ++points) {
        const Loop loop = random_loop(points);
        given("a random loop of ", points, " points");
        expect("vector area", vector_area(loop),
               over_a_surface(loop, 3 * random_vector(), Vec3::Zero()).first, 1e-12, "m^2");
    }
}

TEST_CASE("area: it does not depend on where the loop begins")
{
    Loop loop = random_loop(7);
    const Vec3 area = vector_area(loop);
    for (int i = 0; i < 7; ++i) {
        std::rotate(loop.begin(), loop.begin() + 1, loop.end());
        given("a loop of 7 points, begun at another one");
        expect("vector area", vector_area(loop), area, 1e-13, "m^2");
    }
}

TEST_CASE("area: a millimetre at a kilometre has the area of a millimetre at the origin")
{
    const double size = 1e-3;
    const Vec3 far(1000, -2000, 500);
    const Loop loop = moved(scaled(tile, size), far);
    given("a square of 1 mm, 2 km away");
    expect("vector area over 1 mm^2", Vec3(vector_area(loop) / (size * size)), Vec3(0, 0, 1), 1e-8);
}

TEST_CASE("area: fewer than three points bound nothing")
{
    given("no point, one, and two");
    expect("vector area", vector_area({}), Vec3(0, 0, 0), 0, "m^2");
    expect("vector area", vector_area({Vec3(1, 2, 3)}), Vec3(0, 0, 0), 0, "m^2");
    expect("vector area", vector_area({Vec3(1, 2, 3), Vec3(-4, 0, 1)}), Vec3(0, 0, 0), 0, "m^2");
}

TEST_CASE("area: it is how fast the volume grows that two cubes share")
{
    for (const double a : {0.2, 0.5, 0.9}) {
        given("a cube of 1 m, and one that begins at (", a, ", ", a, ", ", a, ") m");
        expect("vector area", vector_area(around_a_corner(a)), Vec3((1 - a) * (1 - a) * Vec3(1, 1, 1)), 1e-14,
               "m^2");
    }
}

TEST_CASE("way out: against the area, with unit length, at any size")
{
    for (const double size : {1e-6, 1e-3, 1.0, 1e3}) {
        given("two cubes of ", size, " m that share a corner of half their size");
        const std::optional<Vec3> way = separation_direction({scaled(around_a_corner(0.5), size)});
        expect_that("there is a way", way.has_value());
        if (way)
            expect("way", *way, Vec3(-Vec3(1, 1, 1).normalized()), 1e-12);
    }
    if (const std::optional<Vec3> way = separation_direction({around_a_corner(0.5)}))
        say("two cubes that share a corner of 0.5 m: out along ", readable(*way, 3));
}

TEST_CASE("way out: several loops are summed, each with its size")
{
    // A tile of 1 m^2 that looks along z, and one of 4 m^2 that looks along x.
    const Loop large{{0, 0, 0}, {0, 2, 0}, {0, 2, 2}, {0, 0, 2}};
    given("loops of 1 m^2 along z and of 4 m^2 along x");
    const std::optional<Vec3> way = separation_direction({tile, moved(large, {7, 7, 7})});
    expect_that("there is a way", way.has_value());
    if (way)
        expect("way", *way, Vec3(-Vec3(4, 0, 1).normalized()), 1e-12);
}

TEST_CASE("way out: none where the areas cancel")
{
    Loop back(tile.rbegin(), tile.rend());
    given("a bar through a wall: two loops of 1 m^2 that look away from each other");
    const std::optional<Vec3> way = separation_direction({tile, moved(back, {0, 0, 5})});
    expect_that("there is none", !way.has_value());
    if (!way)
        say("a bar through a wall: no way is better than another");
    for (Vec3& point : back)
        point.x() *= 1.01;
    const std::vector<Loop> nearly{tile, moved(back, {0, 0, 5})};
    given("two loops of 1 m^2 and 1.01 m^2 that look away from each other: 0.5 % of their sum is left");
    expect_that("there is none where 1 % counts as cancelled",
                !separation_direction(nearly, 0.01).has_value());
    const std::optional<Vec3> with = separation_direction(nearly);
    expect_that("there is one where 0.1 % does", with.has_value());
    if (with)
        expect("way", *with, Vec3(0, 0, 1), 1e-12);
}

TEST_CASE("way out: `cancelled` is a part of what the areas are summed from, wherever they look")
{
    const Quaternion turn(Eigen::AngleAxisd(0.9, Vec3(1, 2, 3).normalized()));
    std::vector<Loop> nearly{tile, Loop(tile.rbegin(), tile.rend())};
    for (Vec3& point : nearly[1])
        point.x() *= 1.01;
    for (const double size : {1e-3, 1.0, 1e3}) {
        std::vector<Loop> loops = nearly;
        for (Loop& loop : loops)
            for (Vec3& point : loop)
                point = size * (turn * point);
        given("two loops that look away from each other, the second one larger by 1 %, of ", size,
              " m, turned: 0.01 / 2.01 = 0.498 % is left");
        expect_that("there is a way where 0.45 % counts as cancelled",
                    separation_direction(loops, 0.0045).has_value());
        expect_that("there is none where 0.55 % does", !separation_direction(loops, 0.0055).has_value());
    }
    std::vector<Loop> many;
    for (int i = 0; i < 10; ++i) {
        many.push_back(moved(tile, {0, 0, 2.0 * i}));
        many.push_back(moved(Loop(tile.rbegin(), tile.rend()), {0, 0, 2.0 * i + 1}));
    }
    Loop narrow = tile;
    for (Vec3& point : narrow)
        point.x() *= 0.1;
    for (const bool first : {true, false}) {
        std::vector<Loop> loops = many;
        loops.insert(first ? loops.begin() : loops.end(), narrow);
        given(
            "ten loops of 1 m^2 that look up, ten that look down, and one of 0.1 m^2 that looks up, which comes ",
            first ? "first" : "last", ": 0.1 of 20.1 m^2 is left");
        expect_that("there is none where 1 % counts as cancelled", !separation_direction(loops, 0.01));
        expect_that("there is one where 0.4 % does", separation_direction(loops, 0.004).has_value());
    }
}

TEST_CASE("way out: none without a loop, and none of loops without an area")
{
    given("no loop; a loop of two points; a loop that runs there and back");
    expect_that("there is no way without a loop", !separation_direction({}).has_value());
    expect_that("there is no way of two points",
                !separation_direction({{Vec3(0, 0, 0), Vec3(1, 0, 0)}}).has_value());
    expect_that(
        "there is no way of there and back",
        !separation_direction({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(1, 0, 0)}}).has_value());
}

TEST_CASE("turning: a flat tile turns with the lever of its middle")
{
    // The middle is at (2.5, 0.5, 0), the normal along z: (x, y, 0) x (0, 0, 1) = (y, -x, 0).
    const Loop loop = moved(tile, {2, 0, 0});
    given("a square of 1 m with its middle at (2.5, 0.5, 0) m, which looks along z");
    expect("turning about the origin", turning(loop, {0, 0, 0}), Vec3(0.5, -2.5, 0), 1e-13, "m^3");
    expect("turning about its middle", turning(loop, {2.5, 0.5, 0}), Vec3(0, 0, 0), 1e-13, "m^3");
    expect("turning about (2.5, 0.5, 9) m, above its middle", turning(loop, {2.5, 0.5, 9}), Vec3(0, 0, 0),
           1e-13, "m^3");
    const Vec3 about_y(0, -1e-3, 0);
    say("a tile of 1 m, 2 m beside the axis: turning by 1 mrad grows the volume by ",
        about_y.dot(turning(moved(tile, {1.5, 0, 0}), {0, 0, 0})), " m^3");
}

TEST_CASE("turning: it is that of any surface with this border, about any point")
{
    for (int points = 3; points < 12; ++points) {
        const Loop loop = random_loop(points);
        const Vec3 centre = 2 * random_vector();
        given("a random loop of ", points, " points, about ", readable(centre), " m");
        expect("turning", turning(loop, centre), over_a_surface(loop, 3 * random_vector(), centre).second,
               1e-12, "m^3");
    }
}

TEST_CASE("turning: a millimetre at a kilometre, about a point next to it")
{
    const double size = 1e-3;
    const Vec3 far(1000, -2000, 500);
    const Loop loop = moved(scaled(moved(tile, {2, 0, 0}), size), far);
    given("a square of 1 mm, 2 km away, about a point 2.5 mm beside its middle");
    expect("turning over 1 mm^3", Vec3(turning(loop, far) / (size * size * size)), Vec3(0.5, -2.5, 0), 1e-5);
}

TEST_CASE("turning: fewer than three points turn nothing")
{
    given("no point, one, and two");
    expect("turning", turning({}, {1, 0, 0}), Vec3(0, 0, 0), 0, "m^3");
    expect("turning", turning({Vec3(1, 2, 3)}, {1, 0, 0}), Vec3(0, 0, 0), 0, "m^3");
    expect("turning", turning({Vec3(1, 2, 3), Vec3(-4, 0, 1)}, {1, 0, 0}), Vec3(0, 0, 0), 1e-15, "m^3");
}
