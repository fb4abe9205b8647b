#include "chapters/07_implicit_contact/experiments/rest_scenes.hpp"
#include "chapters/07_implicit_contact/experiments/rest_runs.hpp"
#include "chapters/07_implicit_contact/experiments/true_depth.hpp"
#include "chapters/07_implicit_contact/tests/extent.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace enduring;
using chapter07::extent;

namespace {

/// The largest normal force on a pair [N].
struct MostLoad : Probe {
    double at_end = 0;
    void observe(const World&, const Contacts& contacts, double dt) override
    {
        at_end = 0;
        for (const Contact& contact : contacts)
            at_end = std::max(at_end, contact.impulse.norm() / dt);
    }
};

/// By geometry, not by pairs [m].
struct DeepestEver : Probe {
    double depth = 0;
    void observe(const World& world, const Contacts&, double) override
    {
        depth = std::max(depth, chapter07::true_depth(world));
    }
};

std::pair<double, double> heights(const Body& body) { return extent(body, 1); }

}  // namespace

TEST_CASE("card house: of two levels, it stands for a second and moves by less than a millimetre")
{
    Scene scene = chapter07::scene_of(chapter07::card_house(2, 15), 1.0 / 60);
    const chapter07::PileOutcome outcome = chapter07::watch(scene, 1, chapter08_solver);
    CHECK(outcome.moved_mm < 1);
    CHECK(outcome.moved_mm > 0);
    CHECK(outcome.energy_gain_j <= 1e-9);
}

TEST_CASE("card house: with cards that lean farther than friction holds, it falls")
{
    Scene scene = chapter07::scene_of(chapter07::card_house(1, 50), 1.0 / 60);  // tan 50 / 2 = 0.6 > 0.5
    CHECK(chapter07::watch(scene, 1, chapter08_solver).moved_mm > 50);
}

TEST_CASE("arch: of five stones it stands for a second, and too thin for its radius it falls")
{
    Scene thick = chapter07::arch(5, 2, 1.0 / 60), thin = chapter07::arch(20, 16, 1.0 / 60);
    CHECK(chapter07::watch(thick, 1, chapter08_solver).moved_mm < 5);
    CHECK(chapter07::watch(thin, 1, chapter08_solver).moved_mm >
          50);  // an arch stands from a thickness of 0.11 radii on
}

TEST_CASE("crack: a tip wider than the crack rests on its edges, as high as both angles say")
{
    for (const chapter07::Tip tip : {chapter07::Tip::wedge, chapter07::Tip::spike}) {
        Scene scene = chapter07::tip_in_crack(tip, 70, 40, 0.01);
        CHECK(heights(*scene.world.bodies[1]).first == doctest::Approx(1));
        const chapter07::PileOutcome outcome = chapter07::watch(scene, 2, chapter08_solver);
        CHECK(chapter07::is_at_rest(outcome));
        CHECK(outcome.deepest_mm < 0.1);
        if (tip == chapter07::Tip::wedge) {
            const double deg = std::acos(-1.0) / 180;
            const double way = std::tan(20 * deg) / std::tan(35 * deg);
            CHECK(heights(*scene.world.bodies[1]).first == doctest::Approx(1 - way).epsilon(0.02));
        }
    }
}

TEST_CASE("wedge on an edge: it begins in the air, off the middle, and ends on the ground")
{
    Scene scene = chapter07::wedge_on_edge(0.01);
    CHECK(heights(*scene.world.bodies[1]).first > 1);
    CHECK(scene.world.bodies[1]->centre().x() > 0.01);
    chapter07::watch(scene, 3, chapter08_solver);
    CHECK(heights(*scene.world.bodies[1]).first == doctest::Approx(0).epsilon(1e-3));
}

TEST_CASE("wedged cube: it begins off both planes, and rests where it touches both")
{
    for (const double half_angle_deg : {10.0, 40.0}) {
        Scene scene = chapter07::cube_between_planes(half_angle_deg, 0.2, 0.01);
        double nearest = 1e300;
        for (const Plane& plane : scene.world.planes)
            for (const Vec3& x : scene.world.bodies[0]->positions_t0())
                nearest = std::min(nearest, plane.normal.dot(x - plane.point));
        CHECK(nearest == doctest::Approx(0.2 * std::sin(half_angle_deg * std::acos(-1.0) / 180)));
        const chapter07::PileOutcome outcome = chapter07::watch(scene, 2, chapter08_solver);
        CHECK(chapter07::is_at_rest(outcome));
        CHECK(outcome.deepest_mm > 0);
    }
}

TEST_CASE("wedged cube: where it holds itself it rests, no step ends badly, and no pair is wound up")
{
    for (const double dt : {0.01, 1.0 / 60})
        for (const auto& [angle, friction] : {std::pair(10.0, 0.3), {10.0, 1.0}, {20.0, 0.5}, {30.0, 0.8}}) {
            const double half_angle_deg = angle, mu = friction;
            Scene scene = chapter07::cube_between_planes(half_angle_deg, mu, dt);
            MostLoad most;
            const chapter07::PileOutcome outcome = chapter07::watch(scene, 3, chapter08_solver, &most);
            CAPTURE(half_angle_deg);
            CAPTURE(mu);
            CHECK(chapter07::is_at_rest(outcome));
            CHECK(outcome.deepest_mm < 0.6);
            CHECK(outcome.solves.unconverged <=
                  1);  // of 300; the last digit decides which, and it is taken in halves
            CHECK(scene.world.ended_badly == 0);
            CHECK(most.at_end < 50 * 98.1);
        }
}

TEST_CASE("edge on edge: cubes exactly on each other stay where they are to a micrometre, at any angle")
{
    for (const double turn_deg : {0.0, 6.0, 17.0, 45.0}) {
        CAPTURE(turn_deg);
        std::vector<chapter07::Box> boxes;
        for (int i = 0; i < 5; ++i)
            boxes.push_back({10, Vec3(0, 0.5 + i, 0), turn_deg});
        Scene scene = chapter07::scene_of(boxes, 0.01);
        const chapter07::PileOutcome outcome = chapter07::watch(scene, 3, chapter08_solver);
        CHECK(outcome.energy_gain_j <= 1e-9);
        for (const auto& body : scene.world.bodies)
            CHECK(std::hypot(body->centre().x(), body->centre().z()) < 1e-6);  // 8.3e-7 at 6 and 45 degrees
    }
}

TEST_CASE(
    "edge on edge: cubes exactly above each other that fall through small gaps come to stand on one another")
{
    struct Fall {
        int cubes;
        double gap, dt, turn_deg;
    };
    for (const Fall& fall : {Fall{2, 1e-5, 1.0 / 60, 3}, Fall{3, 1e-3, 0.005, 6}, Fall{4, 0.03, 0.01, 3}}) {
        CAPTURE(fall.cubes);
        std::vector<chapter07::Box> boxes;
        for (int i = 0; i < fall.cubes; ++i)
            boxes.push_back({10, Vec3(0, 0.5 + fall.gap + (1 + fall.gap) * i, 0), fall.turn_deg});
        Scene scene = chapter07::scene_of(boxes, fall.dt);
        CHECK(chapter07::watch(scene, 3, chapter08_solver).energy_gain_j <= 1e-9);
        for (int i = 0; i < fall.cubes; ++i)
            CHECK(scene.world.bodies[static_cast<std::size_t>(i)]->centre().y() ==
                  doctest::Approx(0.5 + i).epsilon(2e-3));
    }
}

TEST_CASE("edge on edge: a cube laid one rounding inside another one lies there, and one that hangs over")
{
    for (const double shift : {0.0, 0.3}) {
        const double one_rounding = 1.1e-16;
        Scene scene = chapter07::scene_of({{.centre = {0, 0.5, 0}}}, 0.01);
        scene.world.bodies.push_back(
            std::move(chapter07::scene_of(
                          {{.centre = {shift, 1.4 - one_rounding, 0}, .size = Vec3::Constant(0.8)}}, 0.01)
                          .world.bodies[0]));
        chapter07::watch(scene, 0.5, chapter08_solver);
        CHECK(std::abs(scene.world.bodies[1]->centre().y() - 1.4) < 1e-4);
    }
}

TEST_CASE("crack: wedges of any angle come to rest in wider cracks, and pass neither wall")
{
    std::mt19937 random(3);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    for (int trial = 0; trial < 6; ++trial) {
        const double crack = between(62, 88),
                     tip = between(10, crack - 20);  // friction alone holds no tip there
        CAPTURE(crack);
        CAPTURE(tip);
        Scene scene = chapter07::tip_in_crack(chapter07::Tip::wedge, tip, crack,
                                              trial % 2 == 0 ? 0.01 : 1.0 / 60);
        const chapter07::PileOutcome outcome = chapter07::watch(scene, 6, chapter08_solver);
        const double half_angle = 0.5 * crack * std::acos(-1.0) / 180;
        double behind = 0;
        for (const Vec3& x : scene.world.bodies[1]->positions_t0())
            behind = std::max(behind, std::abs(x.x()) * std::cos(half_angle) - x.y() * std::sin(half_angle));
        CHECK(behind < 2e-5);
        CHECK(outcome.energy_gain_j <= 1e-9);
        CHECK(outcome.drift_um_per_s < 1);
    }
}

TEST_CASE("crack: a spike passes neither wall of a crack, on its way down or at the bottom")
{
    for (const auto& angles : {std::pair(33.0, 60), {12.8, 88}, {53.0, 55}})
        for (const double dt : {0.01, 1.0 / 60}) {
            CAPTURE(angles.second);
            CAPTURE(dt);
            Scene scene = chapter07::tip_in_crack(chapter07::Tip::spike, angles.first, angles.second, dt);
            DeepestEver deepest;
            CHECK(chapter07::watch(scene, 4, chapter08_solver, &deepest).energy_gain_j <= 1e-9);
            CHECK(deepest.depth < 1e-3);
        }
}

TEST_CASE("wedge on an edge: slipping off the edge it is never a millimetre deep, and gains no energy")
{
    for (const double dt : {0.01, 1.0 / 60}) {
        CAPTURE(dt);
        Scene scene = chapter07::wedge_on_edge(dt);
        DeepestEver deepest;
        CHECK(chapter07::watch(scene, 2, chapter08_solver, &deepest).energy_gain_j <= 1e-9);
        CHECK(deepest.depth < 1e-3);
    }
}
