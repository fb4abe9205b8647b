#include "chapters/07_implicit_contact/experiments/true_depth.hpp"
#include "chapters/08_contact_by_distance/experiments/harsh_scenes.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/simulation/energy.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace enduring;
using namespace enduring::chapter08;

namespace {

/// The least and the most that was seen.
struct Span {
    double least = INFINITY, most = 0;

    void add(double value)
    {
        least = std::min(least, value);
        most = std::max(most, value);
    }
};

}  // namespace

TEST_CASE("harsh: a seed gives the same scene twice, to the last bit, and another seed another one")
{
    for (const bool soft : {false, true}) {
        const HarshScene one = harsh_scene(7, soft), same = harsh_scene(7, soft),
                         other = harsh_scene(8, soft);
        CHECK(one.scene.dt == same.scene.dt);
        CHECK(one.scene.dt != other.scene.dt);
        REQUIRE(one.scene.world.bodies.size() == same.scene.world.bodies.size());
        for (std::size_t i = 0; i < one.scene.world.bodies.size(); ++i) {
            const Body &a = *one.scene.world.bodies[i], &b = *same.scene.world.bodies[i];
            CHECK(std::equal(a.positions_t0().begin(), a.positions_t0().end(), b.positions_t0().begin(),
                             b.positions_t0().end()));
            CHECK(a.linear_momentum() == b.linear_momentum());
        }
    }
}

TEST_CASE("harsh: no body begins in another one or in a wall")
{
    for (unsigned seed = 1; seed <= 12; ++seed) {
        CAPTURE(seed);
        CHECK(chapter07::true_depth(harsh_scene(seed, seed % 2 == 0).scene.world) == 0);
    }
}

TEST_CASE("harsh: masses, speeds, steps and counts cover their ranges")
{
    Span mass, speed, dt, count, soft;
    for (unsigned seed = 1; seed <= 60; ++seed) {
        const HarshScene harsh = harsh_scene(seed, true);
        int moving = 0, deformable = 0;
        for (const auto& body : harsh.scene.world.bodies) {
            if (body->is_static())
                continue;
            ++moving;
            const bool is_rigid = body->turning_speed() > 0;  // a soft body's vertices move for themselves
            deformable += !is_rigid;
            if (is_rigid) {
                mass.add(body->mass());
                CHECK(body->turning_speed() == doctest::Approx(20));
            }
            CHECK(body->mean_velocity().norm() == doctest::Approx(harsh.speed));
        }
        count.add(moving);
        soft.add(deformable);
        speed.add(harsh.speed);
        dt.add(harsh.scene.dt);
    }
    const auto covers = [](const Span& span, double least, double most) {
        CHECK(span.least >= least);
        CHECK(span.least < 1.15 * least);
        CHECK(span.most <= most);
        CHECK(span.most > most / 1.15);
    };
    covers(mass, 0.01, 100);
    covers(speed, 10, 100);
    covers(dt, 1e-3, 30e-3);
    CHECK(count.least == 12);
    CHECK(count.most == 27);
    CHECK(soft.least == 1);
    CHECK(soft.most == 3);
}

TEST_CASE("harsh: a spring that is pressed on a plane holds half its load times its depth")
{
    Contact pressed, given;
    pressed.spring.stiffness = 1000;
    pressed.spring.load = 20;
    pressed.spring.stretch = Vec3(0.003, 0, 0.004);
    given.spring.load = 20;  // no stiffness of its own
    CHECK(spring_energy({pressed, given}) ==
          doctest::Approx(0.5 * 20 * (20 / 1000.0) + 0.5 * 1000 * 0.005 * 0.005));
}

TEST_CASE("harsh: soft bodies that an impact turns inside out do not leave the room")
{
    for (const unsigned seed : {84U, 188U}) {
        CAPTURE(seed);
        const HarshOutcome outcome = run_harsh(seed, true, chapter08_solver);
        CHECK(outcome.max_inverted > 10);
        CHECK(outcome.lost == 0);
    }
}

TEST_CASE("harsh: what is left inside by a hit, and moves on inwards, is not lost")
{
    for (const unsigned seed : {1U, 13U}) {
        CAPTURE(seed);
        const HarshOutcome outcome = run_harsh(seed, false, chapter08_solver);
        CHECK(outcome.lost == 0);
        CHECK(outcome.deepest_m < 0.01);
    }
}
