#include "exercises/08_contact_by_distance/4_hand_on.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <numbers>

using namespace enduring;

namespace {

constexpr double degree = std::numbers::pi / 180;

/// The level plane through the origin, turned about z.
FacePlane leaning(double degrees)
{
    return {Vec3::Zero(), {-std::sin(degrees * degree), std::cos(degrees * degree), 0}};
}

/// The facets of a regular prism with a horizontal axis, of radius 1, from its upper side on; and places
/// on the rims between them, a little below both facets.
struct Wheel {
    std::vector<FacePlane> faces;
    std::vector<Vec3> places;
};
Wheel wheel(int count, double depth)
{
    Wheel all;
    for (int i = 0; i <= count; ++i) {
        const double angle = 2 * std::numbers::pi * i / count;
        const Vec3 normal(std::sin(angle), std::cos(angle), 0);
        all.faces.push_back({normal, normal});
        const double between = angle + std::numbers::pi / count;
        all.places.push_back((1 - depth) / std::cos(std::numbers::pi / count) *
                             Vec3(std::sin(between), std::cos(between), 0));
    }
    return all;
}

}  // namespace

TEST_CASE("depth and compression: what the spring feels is the depth less the rest offset, and never a pull")
{
    const FacePlane face{{1, 2, 3}, Vec3(0, 0.6, 0.8)};
    const Vec3 inside = face.point + Vec3(5, 0, 0) - 0.003 * face.normal;
    given("a vertex 3 mm below a face");
    expect("depth", depth_of(face, inside), -0.003, 1e-12, "m");
    expect("compression, rest offset 0", compression_of({1, 0, {}}, face, inside), -0.003, 1e-12, "m");
    expect("compression, rest offset -1 mm", compression_of({1, -0.001, {}}, face, inside), -0.002, 1e-12,
           "m");
    expect("compression, rest offset -5 mm", compression_of({1, -0.005, {}}, face, inside), 0, 1e-12, "m");
    const Vec3 outside = face.point + 0.002 * face.normal;
    given("a vertex 2 mm above a face");
    expect("depth", depth_of(face, outside), 0.002, 1e-12, "m");
    expect("compression, rest offset 0", compression_of({1, 0, {}}, face, outside), 0, 1e-12, "m");
}

TEST_CASE("force: out along the normal, and back along the stretch")
{
    const PairSpring spring{2000, -0.001, {0.0005, 0, 0}};
    given("stiffness 2000 N/m, rest offset -1 mm, stretch 0.5 mm along x, 3 mm below a level face");
    expect("force", force_of(spring, leaning(0), {0, -0.003, 0}), Vec3(-1, 4, 0), 1e-9, "N");
}

TEST_CASE("turn: as Eigen's shortest turn, and nothing happens between equal normals")
{
    RandomInputs random(1);
    for (int trial = 0; trial < 200; ++trial) {
        const Vec3 from = random.direction(), to = random.direction(), vector = 3 * random.direction();
        if (from.dot(to) < -0.9)
            continue;
        given("from ", readable(from), " to ", readable(to), ", vector ", readable(vector));
        expect("turned", turned_along(from, to, vector), Quaternion::FromTwoVectors(from, to) * vector, 1e-9);
        expect("turned between equal ones", turned_along(from, from, vector), vector, 1e-9);
    }
}

TEST_CASE("handed on: compression, stiffness and the size of the force stay")
{
    for (const double degrees : {-40.0, -10.0, 0.0, 20.0, 40.0})
        for (const double rest_offset : {0.0, -0.001, -0.01}) {
            const FacePlane from = leaning(0), to = leaning(degrees);
            // As deep below one as below the other.
            const Vec3 between = (from.normal + to.normal).normalized();
            const Vec3 vertex = -0.003 / between.dot(from.normal) * between;
            const PairSpring spring{5e4, rest_offset, {1e-4, 0, 2e-4}};
            const auto next = handed_on(spring, from, to, vertex, 0.7);
            given("to a face that leans by ", degrees, " degrees, 3 mm below both, rest offset ",
                  1000 * rest_offset, " mm");
            expect_that("it is handed on", next.has_value());
            if (!next)
                continue;
            expect("stiffness", next->stiffness, 5e4, 0, "N/m");
            expect("compression", compression_of(*next, to, vertex), compression_of(spring, from, vertex),
                   1e-12, "m");
            expect("size of the force", force_of(*next, to, vertex).norm(),
                   force_of(spring, from, vertex).norm(), 1e-6, "N");
            expect("stretch across its new face", next->stretch.dot(to.normal), 0, 1e-12, "m");
            expect("length of the stretch", next->stretch.norm(), spring.stretch.norm(), 1e-12, "m");
            expect_that("the rest offset is not positive", next->rest_offset <= 0);
        }
}

TEST_CASE(
    "handed on: below a deeper face it begins with a rest offset by the difference, above a nearer one without rest offset")
{
    const FacePlane low{Vec3::Zero(), Vec3::UnitY()}, high{{0, 0.01, 0}, Vec3::UnitY()};
    const PairSpring spring{1e4, 0, {0, 0, 0}};
    const auto up = handed_on(spring, low, high, {0, -0.002, 0}, 0.7),
               down = handed_on(spring, high, low, {0, -0.002, 0}, 0.7);
    given("2 mm below one face, 12 mm below the other one, rest offset 0");
    expect_that("it is handed on", up.has_value() && down.has_value());
    if (up && down) {
        expect("rest offset, from 2 mm to 12 mm", up->rest_offset, -0.01, 1e-12, "m");
        expect("rest offset, from 12 mm to 2 mm", down->rest_offset, 0, 1e-12, "m");
    }
    const auto nearer = handed_on({1e4, -0.005, {0, 0, 0}}, high, low, {0, -0.002, 0}, 0.7);
    given("from 12 mm deep with a rest offset of -5 mm to 2 mm deep: 7 mm compressed before");
    expect_that("it is handed on", nearer.has_value());
    if (nearer)
        expect("rest offset", nearer->rest_offset, 0, 1e-12, "m");
    const PairSpring loose{1e4, -0.005, {0, 0, 0}};
    const auto still_loose = handed_on(loose, low, high, {0, -0.002, 0}, 0.7);
    given("rest offset -5 mm, 2 mm deep: not compressed at all");
    expect_that("it is handed on", still_loose.has_value());
    if (still_loose)
        expect("compression on the other face", compression_of(*still_loose, high, {0, -0.002, 0}), 0, 1e-12,
               "m");
}

TEST_CASE("handed on: to a face that looks elsewhere nothing is")
{
    const PairSpring spring{1e4, 0, {0, 0, 0}};
    for (const double sign : {1.0, -1.0}) {
        given("a face that leans by ", sign, " times 44 or 46 degrees; least cosine 0.7071");
        expect_that(
            "44 degrees: it is handed on",
            handed_on(spring, leaning(0), leaning(44 * sign), {0, -0.001, 0}, std::sqrt(0.5)).has_value());
        expect_that("46 degrees: it is not",
                    !handed_on(spring, leaning(0), leaning(46 * sign), {0, -0.001, 0}, std::sqrt(0.5)));
        expect_that("150 degrees, nearly the other side: it is not",
                    !handed_on(spring, leaning(0), leaning(150 * sign), {0, -0.001, 0}, std::sqrt(0.5)));
    }
}

TEST_CASE("tour: once around a wheel the spring comes back as it was")
{
    const PairSpring spring{3e4, -0.001, {2e-4, 0, 1e-4}};
    for (const int count : {8, 12, 100}) {
        const Wheel all = wheel(count, 0.004);
        const auto back = after_tour(spring, all.faces, all.places, 0.7);
        given("a wheel of ", count, " facets, 4 mm below each");
        expect_that("it comes back", back.has_value());
        if (!back)
            continue;
        expect("stiffness", back->stiffness, 3e4, 0, "N/m");
        expect("rest offset", back->rest_offset, -0.001, 1e-9, "m");
        expect("stretch", back->stretch, spring.stretch, 1e-9, "m");
    }
    const Wheel all = wheel(12, 0.004);
    const std::vector<FacePlane> half(all.faces.begin(), all.faces.begin() + 7);
    const auto opposite = after_tour(spring, half, all.places, 0.7);
    given("half way around a wheel of 12 facets, 4 mm below each");
    expect_that("it comes through", opposite.has_value());
    if (opposite) {
        expect("rest offset", opposite->rest_offset, -0.001, 1e-9, "m");
        expect("stretch", opposite->stretch, Vec3(-2e-4, 0, 1e-4), 1e-9, "m");
    }
    const Wheel coarse = wheel(7, 0.004);
    given("a wheel of 7 facets: 51 degrees from one to the next");
    expect_that("it does not come back", !after_tour(spring, coarse.faces, coarse.places, 0.7));
    given("a tour of one face, and of none");
    expect_that("it comes back",
                after_tour(spring, {leaning(0)}, {}, 0.7) && after_tour(spring, {}, {}, 0.7));
}

TEST_CASE("tour: around the corner of a ball the stretch has turned by the area that it went around")
{
    // Along an eighth of a unit sphere: from y to x to z and back to y, in small steps; its area is pi / 2.
    std::vector<FacePlane> faces;
    std::vector<Vec3> places;
    const std::vector<Vec3> corners{Vec3::UnitY(), Vec3::UnitX(), Vec3::UnitZ(), Vec3::UnitY()};
    for (std::size_t leg = 0; leg < 3; ++leg)
        for (int i = 0; i < 90; ++i) {
            const double angle = i * degree;
            const Vec3 normal = std::cos(angle) * corners[leg] + std::sin(angle) * corners[leg + 1];
            faces.push_back({normal, normal});
            places.emplace_back(0.99 * normal);
        }
    faces.push_back({Vec3::UnitY(), Vec3::UnitY()});
    const auto back = after_tour({1e4, 0, {1e-3, 0, 0}}, faces, places, 0.7);
    given("a tour around an eighth of a ball, stretch 1 mm along x");
    expect_that("it comes back", back.has_value());
    if (!back)
        return;
    expect("length of the stretch", back->stretch.norm(), 1e-3, 1e-12, "m");
    expect("stretch along its first direction", back->stretch.x(), 0, 1e-9, "m");
    const double angle = std::acos(back->stretch.normalized().dot(Vec3::UnitX())) / degree;
    say("around an eighth of a ball the stretch turns by ", angle, " degrees");
}
