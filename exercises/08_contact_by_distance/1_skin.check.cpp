#include "exercises/08_contact_by_distance/1_skin.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <numbers>

using namespace enduring;

namespace {

constexpr SkinnedPair cubes{5e-4, 5e-4, 1000, 0.01};  // of 1 m

std::string told(const SkinnedPair& pair, const ComingSurfaces& start)
{
    return in_words("skins ", 1e3 * pair.skin_a, " mm and ", 1e3 * pair.skin_b, " mm, h ", pair.h, ", dt ",
                    pair.dt, " s, distance ", 1e3 * start.distance, " mm, speed ", start.speed, " m/s");
}

/// The speed after a step with a spring, by bisection: what the mass loses is what the spring gives.
double speed_by_bisection(const SkinnedPair& pair, const ComingSurfaces& start)
{
    const double mass = 3, k = pair.h * mass / (pair.dt * pair.dt);
    double low = std::min(start.speed, 0.0) - 1e3 * (pair.skin_a + pair.skin_b) / pair.dt, high = start.speed;
    for (int i = 0; i < 200; ++i) {
        const double speed = (low + high) / 2, end = start.distance - pair.dt * speed;
        const double pressed = std::max(0.0, pair.skin_a + pair.skin_b - end);
        (mass * (start.speed - speed) > k * pair.dt * pressed ? low : high) = speed;
    }
    return (low + high) / 2;
}

void expect_step(const SkinnedPair& pair, const ComingSurfaces& start, double speed)
{
    const ComingSurfaces got = after_pressed_step(pair, start);
    given(told(pair, start));
    expect("speed after", got.speed, speed, 1e-9 * (1 + std::abs(start.speed)), "m/s");
    expect("distance after", got.distance, start.distance - pair.dt * speed,
           1e-10 * (1 + std::abs(start.speed)), "m");
}

/// The planes at the tip of a needle: it is as wide as twice this angle.
std::vector<Vec3> needle(double degrees, int sides)
{
    const double angle = degrees * std::numbers::pi / 180;
    std::vector<Vec3> normals;
    for (int i = 0; i < sides; ++i) {
        const double around = 2 * std::numbers::pi * i / sides;
        normals.emplace_back(std::cos(angle) * std::cos(around), std::sin(angle),
                             std::cos(angle) * std::sin(around));
    }
    return normals;
}

}  // namespace

TEST_CASE("prediction: a speed is written down")
{
    expect_that("the prediction is positive", predicted_speed() > 0 && std::isfinite(predicted_speed()));
}

TEST_CASE("compression: what the distance lacks of both skins, and never less than nothing")
{
    const SkinnedPair pair{2e-4, 5e-4, 100, 0.01};
    given("skins 0.2 mm and 0.5 mm");
    expect("compression at 0.5 mm", compression_at(pair, 5e-4), 2e-4, 1e-15, "m");
    expect("compression at 0", compression_at(pair, 0), 7e-4, 1e-15, "m");
    expect("compression at 0.7 mm", compression_at(pair, 7e-4), 0, 1e-15, "m");
    expect("compression at 1 m", compression_at(pair, 1), 0, 1e-15, "m");
}

TEST_CASE("step: what is neither near nor crosses moves on")
{
    expect_step(cubes, {0.5, 10}, 10);
    expect_step(cubes, {2e-3, 0.15}, 0.15);  // it ends within the skins: the next step has a pair
    expect_step(cubes, {5e-4, -3}, -3);      // near, and it moves away
    expect_step(cubes, {5e-4, -0.06}, -0.06);
}

TEST_CASE("step: a pair takes from the mass what its spring gives")
{
    RandomInputs random(8);
    for (int trial = 0; trial < 200; ++trial) {
        const SkinnedPair pair{random.number(1e-4, 1e-3), random.number(1e-4, 1e-3),
                               std::exp(random.number(0, 8)), random.number(1e-3, 0.02)};
        const double skins = pair.skin_a + pair.skin_b;
        const ComingSurfaces near{random.number(0.01, 0.99) * skins, random.number(-0.2, 20)};
        expect_step(pair, near, speed_by_bisection(pair, near));
        const double distance = random.number(1.5, 40) * skins;
        const ComingSurfaces crossing{distance, distance / pair.dt * random.number(1.01, 4)};
        expect_step(pair, crossing, speed_by_bisection(pair, crossing));
    }
    const double left = after_pressed_step(cubes, {1e-3 - 1e-12, 10}).distance;
    say("two cubes of 1 m, 10 m/s, 10 ms: pressed by ", 1e3 * (1e-3 - left), " mm of 1 mm");
}

TEST_CASE("fastest: below it no step lets the surfaces cross, and above it some step does")
{
    RandomInputs random(9);
    for (int trial = 0; trial < 50; ++trial) {
        const SkinnedPair pair{random.number(1e-4, 1e-3), random.number(1e-4, 1e-3),
                               std::exp(random.number(2, 8)), random.number(1e-3, 0.02)};
        const double fastest = fastest_held(pair), skins = pair.skin_a + pair.skin_b;
        double lowest = skins;
        for (double part = 1e-6; part < 3; part *= 1.2) {
            const ComingSurfaces start{part * skins, 0.999 * fastest};
            lowest = std::min(lowest, start.distance - pair.dt * speed_by_bisection(pair, start));
        }
        const ComingSurfaces worst{1e-6 * skins, 1.001 * fastest};
        given("skins ", 1e3 * skins, " mm together, h ", pair.h, ", dt ", pair.dt, " s, your speed ", fastest,
              " m/s");
        expect_that("at 0.999 of your speed they never cross", lowest > 0);
        expect_that("at 1.001 of your speed they cross if they begin in touch",
                    worst.distance - pair.dt * speed_by_bisection(pair, worst) < 0);
    }
    say("held in steps of 10 ms: up to ", fastest_held(cubes), " m/s, you predicted ", predicted_speed());
}

TEST_CASE("halvings: as few as hold the speed, and no more than are allowed")
{
    const auto expect_halvings = [](const SkinnedPair& pair, double speed, int most, int expected) {
        given(told(pair, {0, speed}), ", at most ", most, " halvings");
        expect("halvings", halvings_for(pair, speed, most), expected, 0);
    };
    const SkinnedPair soft{5e-4, 5e-4, 100, 0.01};  // holds 10 m/s
    expect_halvings(soft, 9.9, 5, 0);
    expect_halvings(soft, 10.05, 5, 1);
    expect_halvings(soft, 19.9, 5, 1);
    expect_halvings(soft, 20.1, 5, 2);
    expect_halvings(soft, 70, 5, 3);
    expect_halvings(soft, 319, 10, 5);
    expect_halvings(soft, 1000, 5, 5);
    expect_halvings(soft, 1000, 0, 0);
    expect_halvings({2e-4, 1e-4, 1000, 0.01}, 70, 5, 2);
    expect_halvings(soft, -50, 5, 0);
    say("a shot at 200 m/s: halvings with h = 1000: ", halvings_for(cubes, 200, 10),
        ", with h = 100: ", halvings_for(soft, 200, 10));
}

TEST_CASE("inset: a side, an edge and a corner of a cube move so that each side moves by the skin")
{
    const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
    given("skin 1 mm, the side that looks along y");
    expect("move", inset_of_vertex({y}, 1e-3), Vec3(0, -1e-3, 0), 1e-12, "m");
    given("skin 1 mm, the edge between the sides along x and -z");
    expect("move", inset_of_vertex({x, -z}, 1e-3), Vec3(-1e-3, 0, 1e-3), 1e-12, "m");
    given("skin 2 mm, the corner of the sides along x, -y and z");
    expect("move", inset_of_vertex({x, -y, z}, 2e-3), Vec3(-2e-3, 2e-3, -2e-3), 1e-12, "m");
}

TEST_CASE("inset: where bodies touch as they are drawn, nothing is compressed")
{
    RandomInputs random(10);
    for (int trial = 0; trial < 20; ++trial) {
        const double skin_a = random.number(1e-4, 1e-3), skin_b = random.number(1e-4, 1e-3);
        const Vec3 normal = random.direction(), along = normal.cross(random.direction()).normalized();
        const Vec3 corner = inset_of_vertex({-normal, along, normal.cross(along)}, skin_a),
                   side = inset_of_vertex({normal}, skin_b);
        const double distance = normal.dot(corner - side);
        given("a corner with a skin of ", skin_a, " m stands on a side with ", skin_b, " m");
        expect("distance of the contact surfaces", distance, skin_a + skin_b, 1e-12, "m");
        expect("compression", compression_at({skin_a, skin_b, 1000, 0.01}, distance), 0, 1e-12, "m");
    }
}

TEST_CASE("inset: three planes that lean against each other all move by the skin")
{
    RandomInputs random(11);
    for (int trial = 0; trial < 50; ++trial) {
        const Vec3 axis = random.direction();
        std::vector<Vec3> normals;
        for (int i = 0; i < 3; ++i)
            normals.push_back((Vec3(Vec3::Unit(i)) + random.number(0.1, 0.4) * axis).normalized());
        const Vec3 move = inset_of_vertex(normals, 1e-3);
        given("planes with the normals ", readable(normals[0]), ", ", readable(normals[1]), ", ",
              readable(normals[2]), ", skin 1 mm");
        for (const Vec3& normal : normals)
            expect("a plane moves outwards by", normal.dot(move), -1e-3, 1e-10, "m");
    }
}

TEST_CASE("inset: where more planes meet than a vertex can follow, no other move has smaller squares")
{
    RandomInputs random(12);
    for (int trial = 0; trial < 100; ++trial) {
        std::vector<Vec3> normals;
        for (int i = 0; i < 6; ++i)
            normals.push_back((Vec3::UnitY() + 0.8 * random.direction()).normalized());
        const auto missing = [&](const Vec3& move) {
            double sum = 0;
            for (const Vec3& normal : normals)
                sum += std::pow(normal.dot(move) + 1, 2);
            return sum;
        };
        const Vec3 move = inset_of_vertex(normals, 1);
        given("six planes, the first with the normal ", readable(normals[0]), ", skin 1 m; trial ", trial);
        for (int other = 0; other < 10; ++other)
            expect_that("another move leaves more",
                        missing(move + 0.05 * random.direction()) > missing(move));
    }
}

TEST_CASE("inset: a tip recedes along its axis, and that of a needle stays where its planes say little")
{
    for (const double degrees : {10.0, 20.0, 45.0, 80.0})
        for (const int sides : {3, 8}) {
            given("a tip with ", sides, " sides, ", 2 * degrees, " degrees wide, skin 1 m");
            const double expected = -1 / std::sin(degrees * std::numbers::pi / 180);
            expect("move", inset_of_vertex(needle(degrees, sides), 1), Vec3(0, expected, 0), 1e-9, "m");
        }
    for (const double degrees : {0.1, 1.0, 3.9}) {
        given("a tip with 8 sides, ", 2 * degrees, " degrees wide, skin 1 m");
        expect("move", inset_of_vertex(needle(degrees, 8), 1), Vec3(0, 0, 0), 1e-9, "m");
    }
    given("a blade of 4 degrees, skin 1 m");
    expect("move", inset_of_vertex({needle(2, 2)[0], needle(2, 2)[1]}, 1), Vec3(0, 0, 0), 1e-9, "m");
    const auto skins = [](double degrees) {
        return std::round(100 * inset_of_vertex(needle(degrees, 8), 1).norm()) / 100;
    };
    say("a tip that is 20 degrees wide recedes by ", skins(10), " skins, one that is 6 degrees wide by ",
        skins(3));
}
