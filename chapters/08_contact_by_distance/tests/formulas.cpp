#include "chapters/08_contact_by_distance/experiments/bouncing_scenes.hpp"
#include "chapters/08_contact_by_distance/experiments/euler_disk.hpp"
#include "chapters/08_contact_by_distance/experiments/gears.hpp"
#include "chapters/08_contact_by_distance/experiments/limits.hpp"
#include "chapters/08_contact_by_distance/experiments/polygon_gears.hpp"
#include "chapters/08_contact_by_distance/experiments/sphere_impacts.hpp"
#include "common/geometry/surface_topology.hpp"
#include "common/input/input_error.hpp"
#include "common/rigid/mass_properties.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace enduring;
using namespace enduring::chapter08;

TEST_CASE(
    "sphere impacts: velocity and spin after a strike are those of min(mu J_n, m_t slip), and no ball rebounds")
{
    for (const double along : {0.3, 0.9, 3.0}) {  // the first two stick
        CAPTURE(along);
        const AfterImpact after = strike({.along = along, .dt = 1e-4});
        CHECK(after.largest_off < 0.01);
        CHECK(std::abs(after.rebound) < 0.01);
    }
}

TEST_CASE("sphere impacts: balls part with their coefficient of restitution of the speed at which they met")
{
    for (const double other_radius : {0.0, sphere_radius})
        for (const double restitution : {0.4, 1.0}) {
            CAPTURE(other_radius);
            CAPTURE(restitution);
            const SphereImpact impact{.restitution = restitution, .other_radius = other_radius};
            CHECK(strike(impact).rebound == doctest::Approx(restitution).epsilon(1e-3));
        }
}

TEST_CASE("sphere impacts: with a rebound friction takes 1 + e times as much, and no more than the slip")
{
    for (const double restitution : {0.5, 1.0})
        for (const double along : {0.5, 8.0}) {  // sticks, slides
            CAPTURE(restitution);
            CAPTURE(along);
            const AfterImpact after = strike({.along = along, .restitution = restitution, .dt = 1e-4});
            CHECK(after.largest_off < 0.01);
            CHECK(after.rebound == doctest::Approx(restitution).epsilon(0.01));
        }
    CHECK(strike({.spin = 15, .restitution = 0.5, .other_radius = 0.25, .dt = 1e-4}).largest_off < 0.01);
}

TEST_CASE("sphere impacts: two balls that spin rebound, also where they meet at the end of a step")
{
    constexpr double dt = 5e-4;
    for (const double off : {-1e-9, -1e-12, 0.0, 1e-12, 1e-9, 1e-6, 3e-6, 1e-5, 1e-4}) {
        CAPTURE(off);
        CHECK(strike({.spin = 5,
                      .restitution = 0.8,
                      .other_radius = 0.25,
                      .other_spin = 5,
                      .dt = dt,
                      .subdivisions = 2,
                      .gap = 3 * dt + off})
                  .rebound == doctest::Approx(0.8).epsilon(0.05));
    }
}

TEST_CASE(
    "bouncing: a cube of balls falls apart, and an elastic one keeps its energy and its momentum along the ground")
{
    const BallsApart elastic = balls_apart(2, 1, 0.01, 0.5), clay = balls_apart(2, 0, 0.01, 0.5);
    CHECK(elastic.energy.left > 0.98);
    CHECK(elastic.energy.most_gained < 1e-9);
    CHECK(clay.energy.left < 0.9);
    CHECK(clay.deepest < 1e-3);
    CHECK(elastic.sideways < 1e-9);
    CHECK(balls_apart(2, 1, 0.0025, 0.5).energy.left > elastic.energy.left);
}

TEST_CASE("sphere impacts: of two balls each takes its share, also if one is larger or spins")
{
    CHECK(strike({.spin = 15, .other_radius = 0.1, .other_spin = 15, .dt = 1e-4}).largest_off < 0.015);
    CHECK(strike({.spin = 15, .other_radius = 0.25, .dt = 1e-4}).largest_off < 0.015);
    CHECK(strike({.spin = 30, .other_radius = 0.25, .dt = 1e-4}).largest_off < 0.02);
}

TEST_CASE("sphere impacts: a ball slides for 2 v / (7 mu g) and rolls with 5/7 v, within its facets")
{
    const SlideToRoll coarse = slide_to_roll(0.002, 3), fine = slide_to_roll(0.002, 4);
    CHECK(std::abs(fine.time.error()) < 0.03);
    CHECK(std::abs(fine.speed.error()) < 0.02);
    CHECK(std::abs(fine.speed.error()) < std::abs(coarse.speed.error()));
}

TEST_CASE(
    "Euler's disk: a thin one has the rate sqrt(4 g / (a sin)), and a thick one solves the law of its angular momentum")
{
    const double a = 0.1, lean = 0.3;
    CHECK(disk_rate(a, 0, a * a / 4, a * a / 2, lean) ==
          doctest::Approx(std::sqrt(4 * 9.81 / (a * std::sin(lean)))));
    const double b = 0.02, across = a * a / 4 + b * b / 3, along = a * a / 2,
                 rate = disk_rate(a, b, across, along, lean);
    const Vec3 up(-std::sin(lean), std::cos(lean), 0), axis = Vec3::UnitY(),
                                                       to_rim(a, -b, 0);  // in the disk's axes
    const Vec3 turning = -rate * std::sin(lean) / a * to_rim;
    const Vec3 momentum(across * turning.x(), along * turning.y(), 0);
    CHECK((rate * up.cross(momentum) - to_rim.cross(9.81 * up)).norm() < 1e-12);
    CHECK(turning.cross(to_rim).norm() < 1e-12);
    CHECK(axis.dot(up) == doctest::Approx(std::cos(lean)));
}

TEST_CASE("Euler's disk: it goes round as the formula says, with friction and without, and gains no energy")
{
    for (const double mu : {0.0, 1.0}) {
        CAPTURE(mu);
        const DiskRun run = spin_disk({.sides = 96, .mu = mu}, 0.2);
        CHECK(run.rate == doctest::Approx(run.by_formula).epsilon(0.03));
        CHECK(run.energy_change < 1e-6);
    }
}

TEST_CASE("limits: slopes hold to atan(mu), boxes topple from atan(w/h) on, and jaws pinch from tan on")
{
    CHECK(std::abs(slope_limit(0.3, 0.01).error()) < 2e-3);
    CHECK(std::abs(toppling_limit(2, 0.01).error()) < 3e-3);
    CHECK(std::abs(pinch_limit(15, 0.01).error()) < 2e-3);
}

TEST_CASE(
    "limits: the thinnest half circle of many stones has 0.1075 of its radius, and of few stones it is thinner")
{
    CHECK(thinnest_arch(2000) == doctest::Approx(0.1075).epsilon(2e-3));
    CHECK(thinnest_arch(10) < thinnest_arch(40));
}

TEST_CASE("limits: an arch of ten stones falls at the thickness that the line of thrust needs")
{
    CHECK(std::abs(arch_limit(10, 0.01).error()) < 0.03);
}

TEST_CASE(
    "gears: closed, with involute flanks that are as far apart at the pitch circle as the play leaves them")
{
    const GearShape shape;
    const SurfaceMesh mesh = gear(shape);
    CHECK(mass_properties(mesh, 1).mass > 0);  // throws where it is open
    // The normal of an involute is tangent to the base circle: facets of its flanks pass the axis in this
    // distance.
    const double base = shape.pitch_radius() * std::cos(shape.pressure_deg * std::numbers::pi / 180);
    const Vec3 middle = 0.5 * (mesh.vertices[4] + mesh.vertices[5]),
               along = mesh.vertices[5] - mesh.vertices[4];
    CHECK(std::abs(middle.dot(along.normalized())) == doctest::Approx(base).epsilon(2e-3));
    CHECK_THROWS_AS(gear({.teeth = 8}), InputError);
}

TEST_CASE("gears: a pair keeps its ratio, and gains speed by its torques and moments of inertia")
{
    const GearRun run = turn_gears({}, 0.4);
    CHECK(run.turns >= 0.4);
    CHECK(run.ratio == doctest::Approx(run.exact).epsilon(2e-3));
    CHECK(run.acceleration == doctest::Approx(run.by_formula).epsilon(0.03));
    CHECK(run.apart_um < 100);
    CHECK(run.lost > -1e-6);
}

TEST_CASE("gears: in short steps facets cost what they cost two rigid polygons without a bounce")
{
    const GearPair pair{.dt = 0.0002};
    const GearRun run = turn_gears(pair, 4);
    const double by_polygons = acceleration_of_polygons(pair, 4);
    CHECK(by_polygons < 0.98 * run.by_formula);
    CHECK(run.acceleration == doctest::Approx(by_polygons).epsilon(0.02));
}

TEST_CASE("gears: teeth that pass facets of each other in one step stop no gear")
{
    for (const int facets : {6, 8}) {
        CAPTURE(facets);
        const GearRun run = turn_gears({.flank_points = facets, .dt = 0.002}, 4);
        CHECK(run.turns >= 4);
        CHECK(run.acceleration == doctest::Approx(run.by_formula).epsilon(0.03));
    }
}
