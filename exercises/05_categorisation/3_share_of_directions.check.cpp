#include "exercises/05_categorisation/3_share_of_directions.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <cmath>
#include <numbers>

namespace enduring::chapter05 {
namespace {

std::array<Vec3, 3> three_normals(const Corner& corner)
{
    const std::vector<Vec3> span = normal_span(corner.surface(), corner.faces());
    return {span[0], span[1], span[2]};
}

}  // namespace

TEST_CASE("prediction: a share is written down")
{
    expect_that("the predicted share lies between 0 and 1", predicted_share() >= 0 && predicted_share() <= 1);
}

TEST_CASE("directions: they have unit length, no favourite side, and fill every cap with its share")
{
    const std::vector<Vec3> directions = even_directions(5000);
    given("5000 directions");
    expect("how many there are", directions.size(), 5000, 0);
    if (directions.size() != 5000)
        return;
    Vec3 sum = Vec3::Zero();
    int of_other_length = 0;
    for (const Vec3& direction : directions) {
        sum += direction;
        of_other_length += !(std::abs(direction.norm() - 1) < 1e-12);
    }
    expect("how many have not unit length", of_other_length, 0, 0);
    expect("their mean", Vec3(sum / 5000), Vec3(0, 0, 0), 1e-3);
    for (const Vec3& axis : {Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(2, -1, 3).normalized().eval()}) {
        int near = 0;
        for (const Vec3& direction : directions)
            near += direction.dot(axis) > 0.5;
        given("5000 directions, and of them those within 60 degrees of ", readable(axis));
        expect("share", near / 5000.0, 0.25, 0.005);
    }
}

TEST_CASE("directions: every ring's direction stands at half its height, so the poles are alike")
{
    given("4 directions, one in each of four rings of the height 0.5");
    const std::vector<Vec3> directions = even_directions(4);
    expect("how many there are", directions.size(), 4, 0);
    for (std::size_t i = 0; i < directions.size() && i < 4; ++i)
        expect("height of number " + readable(i), directions[i].y(), 0.75 - 0.5 * static_cast<double>(i),
               1e-12);
}

TEST_CASE("directions: each is turned by the golden angle against the one before, so no line of them forms")
{
    const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
    for (const int count : {3, 50}) {
        given(count, " directions, seen from the pole");
        const std::vector<Vec3> directions = even_directions(count);
        REQUIRE(static_cast<int>(directions.size()) == count);
        for (int i = 1; i < count; ++i) {
            const Vec3 &one = directions[static_cast<std::size_t>(i) - 1],
                       &next = directions[static_cast<std::size_t>(i)];
            const double angle = std::atan2(one.z() * next.x() - one.x() * next.z(),
                                            one.x() * next.x() + one.z() * next.z());
            expect("turn from number " + readable(i - 1) + " to the next, one way or the other",
                   std::abs(angle), turn, 1e-9, "rad");
        }
    }
}

TEST_CASE("measurement: it is a part of just as many directions as are asked for")
{
    for (const std::string name : {"cube", "tetrahedron"})
        for (const int count : {7, 60, 900}) {
            int touching = 0;
            for (const Vec3& direction : even_directions(count))
                touching += can_touch(sphere_corner(name), direction);
            given("corner of a ", name, ", ", count, " directions, of which ", touching, " can touch");
            expect("share", measured_share(sphere_corner(name), count), static_cast<double>(touching) / count,
                   1e-12);
        }
}

TEST_CASE("measurement: a board touches a cube's corner from an eighth of all sides, a flat vertex from none")
{
    given("20000 directions");
    expect("share of a cube's corner", measured_share(sphere_corner("cube"), 20000), 0.125, 0.002);
    expect("share of a flat vertex", measured_share(sphere_corner("flat"), 20000), 0.0, 1e-3);
}

TEST_CASE("law: three normals at right angles cover an eighth, three in a plane half of the sphere")
{
    expect("at right angles", law_of_share({Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}), 0.125, 1e-12);
    const double c = std::cos(2 * std::numbers::pi / 3), s = std::sin(2 * std::numbers::pi / 3);
    expect("120 degrees apart in a plane", law_of_share({Vec3(1, 0, 0), Vec3(c, s, 0), Vec3(c, -s, 0)}), 0.5,
           1e-7);
    expect("in the other order", law_of_share({Vec3::UnitX(), Vec3::UnitZ(), Vec3::UnitY()}), 0.125, 1e-12);
}

TEST_CASE("law: a triangle with two right angles has the share of its third")
{
    for (const double angle : {1e-5, 0.3, 1.5, 3.0}) {
        const std::array<Vec3, 3> normals{Vec3::UnitZ(), Vec3::UnitX(),
                                          Vec3(std::cos(angle), std::sin(angle), 0)};
        given("normals along z, along x and ", angle, " rad from x in their plane");
        expect("share over that angle", law_of_share(normals) / angle, 1 / (4 * std::numbers::pi), 1e-9);
    }
}

TEST_CASE("law: a small triangle is as good as flat, and its share is its area over that of the sphere")
{
    for (const double side : {1e-2, 1e-4}) {
        const std::array<Vec3, 3> normals{Vec3::UnitZ(), Vec3(side, 0, 1).normalized(),
                                          Vec3(0, side, 1).normalized()};
        given("the normal along z and two that lean by ", side, " rad towards x and towards y");
        expect("share over side^2 / 2 / (4 pi)", law_of_share(normals) * 8 * std::numbers::pi / (side * side),
               1.0, 1e-3);
    }
}

TEST_CASE("law: a triangle that is cut in two has the share of its parts")
{
    RandomInputs random(3);
    for (int i = 0; i < 50; ++i) {
        const Vec3 a = random.direction(), b = random.direction(), c = random.direction(),
                   between = (0.3 * b + 0.7 * c).normalized();
        given("normals ", readable(a), ", ", readable(b), ", ", readable(c),
              ", cut at a point between the last two");
        expect("share", law_of_share({a, b, c}),
               law_of_share({a, b, between}) + law_of_share({a, between, c}), 1e-9);
    }
}

TEST_CASE("law: measured and law agree at a cube's corner and at a tetrahedron's tip")
{
    for (const std::string name : {"cube", "tetrahedron"}) {
        given("corner of a ", name, ", 20000 directions");
        const double measured = measured_share(sphere_corner(name), 20000),
                     law = law_of_share(three_normals(sphere_corner(name)));
        expect("share", measured, law, 0.002);
        say(name == "cube" ? "a cube's corner: " : "a tetrahedron's tip: ",
            std::round(1000 * measured) / 1000, " measured, ", law, " by the law");
    }
    say("you predicted ", predicted_share());
}

}  // namespace enduring::chapter05
