#include "common/simulation/given_motion.hpp"

#include "common/geometry/box_shapes.hpp"
#include "common/simulation/driven_body.hpp"
#include "common/simulation/step.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

using namespace enduring;

namespace {

/// Four rows at uneven times, with turns about different axes, one of more than a whole turn.
GivenMotion uneven()
{
    return GivenMotion::through({{0.5, Vec3(1, 0, 0), Vec3::Zero()},
                                 {0.9, Vec3(1, 2, 0), Vec3(0, 1, 0.5)},
                                 {2.0, Vec3(-1, 2, 3), Vec3(0, 7, 0)},
                                 {2.25, Vec3(0, 0, 3), Vec3(1, 7, 1)}});
}

SurfaceMesh placed_box() { return box({1, 0.2, 0.5}); }

Vec3 vertex_at(const GivenMotion& motion, double time)
{
    return DrivenBody("box", placed_box(), Vec3(0.3, 0, 0), motion, time).positions_t0()[0];
}

}  // namespace

TEST_CASE("given motion: a table has the places of its rows, and rests before and after them")
{
    const GivenMotion motion = uneven();
    CHECK((motion.at(0.9).displacement - Vec3(1, 2, 0)).norm() < 1e-14);
    CHECK((motion.at(0.9).turn - Vec3(0, 1, 0.5)).norm() < 1e-14);
    CHECK((motion.at(2.0).turn - Vec3(0, 7, 0)).norm() < 1e-14);
    for (const double time : {-3.0, 0.5, 2.25, 100.0}) {
        CAPTURE(time);
        const GivenPlace place = motion.at(time);
        CHECK(place.displacement == (time < 1 ? Vec3(1, 0, 0) : Vec3(0, 0, 3)));
        CHECK(place.velocity == Vec3::Zero());
        CHECK(place.angular_velocity == Vec3::Zero());
    }
}

TEST_CASE(
    "given motion: a parabola that rises and is sampled unevenly is hit at all inner rows, with its slope")
{
    const auto height = [](double t) { return Vec3(0, 3 * t * t + 2 * t + 1, 0); };
    std::vector<GivenMotion::Row> rows;
    for (const double t : {0.0, 0.1, 0.4, 0.5, 1.3, 2.0})
        rows.push_back({t, height(t), Vec3::Zero()});
    const GivenMotion motion = GivenMotion::through(rows);
    for (double t = 0.1; t < 1.3; t += 0.037) {
        CHECK((motion.at(t).displacement - height(t)).norm() < 1e-13);
        CHECK(motion.at(t).velocity.y() == doctest::Approx(6 * t + 2));
    }
}

TEST_CASE("given motion: the velocity of every vertex is the slope of its path, and continuous at the rows")
{
    const GivenMotion motion = uneven();
    constexpr double h = 1e-6;
    for (const double time : {0.5, 0.6, 0.9, 1.5, 1.999, 2.0, 2.1, 2.25}) {
        CAPTURE(time);
        const DrivenBody body("box", placed_box(), Vec3(0.3, 0, 0), motion, time);
        const Vec3 before = (vertex_at(motion, time) - vertex_at(motion, time - h)) / h,
                   after = (vertex_at(motion, time + h) - vertex_at(motion, time)) / h;
        CHECK((body.velocity(0) - 0.5 * (before + after)).norm() < 1e-4);
        CHECK((before - after).norm() < 1e-3);
    }
}

TEST_CASE(
    "given motion: between two rows no coordinate leaves what lies between their values, nor turns back")
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> gap(0.01, 2), far(-3, 3);
    std::vector<GivenMotion::Row> rows;
    double time = 0;
    for (int i = 0; i < 200; ++i) {
        rows.push_back(
            {time += gap(random), Vec3(far(random), far(random), far(random)), Vec3(far(random), 0, 0)});
        if (i % 3 == 2)
            rows.back().displacement.y() = rows[rows.size() - 2].displacement.y();
    }
    const GivenMotion motion = GivenMotion::through(rows);
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const GivenMotion::Row &from = rows[i - 1], &to = rows[i];
        CAPTURE(i);
        GivenPlace last = motion.at(from.time);
        for (int part = 1; part < 50; ++part) {
            const GivenPlace now = motion.at(from.time + part * (to.time - from.time) / 50);
            const Vec3 way = to.displacement - from.displacement,
                       moved = now.displacement - last.displacement;
            for (Eigen::Index c = 0; c < 3; ++c) {
                CHECK(moved[c] * way[c] >= -1e-12);
                CHECK(now.velocity[c] * way[c] >= -1e-12);
                CHECK((to.displacement[c] - now.displacement[c]) * way[c] >= -1e-12);
            }
            CHECK((now.turn.x() - last.turn.x()) * (to.turn.x() - from.turn.x()) >= -1e-12);
            if (way.y() == 0)
                CHECK((now.velocity.y() == 0 && now.displacement.y() == to.displacement.y()));
            last = now;
        }
    }
}

TEST_CASE("given motion: a row that gives velocities has them, so a motion may begin and end at once")
{
    const auto row = [](double time, const Vec3& place, const Vec3& velocity) {
        return GivenMotion::Row{.time = time,
                                .displacement = place,
                                .turn = Vec3::Zero(),
                                .velocity = velocity,
                                .gives_velocity = true};
    };
    const GivenMotion jumps =
        GivenMotion::through({row(0, Vec3::Zero(), {2, 0, 0}), row(1, {2, 0, 0}, {2, 0, 0}),
                              row(1 + 1e-6, {2, 0, 0}, {0, -3, 0}), row(2 + 1e-6, {2, -3, 0}, {0, -3, 0})});
    for (const double time : {0.0, 0.3, 0.999}) {
        CHECK((jumps.at(time).displacement - Vec3(2 * time, 0, 0)).norm() < 1e-12);
        CHECK((jumps.at(time).velocity - Vec3(2, 0, 0)).norm() < 1e-12);
    }
    for (const double time : {1.1, 1.9}) {
        CHECK((jumps.at(time).displacement - Vec3(2, 3 * (1 + 1e-6 - time), 0)).norm() < 1e-12);
        CHECK((jumps.at(time).velocity - Vec3(0, -3, 0)).norm() < 1e-12);
    }
    CHECK(jumps.at(-1e-9).velocity == Vec3::Zero());
    CHECK(jumps.at(2 + 1e-6).velocity == Vec3::Zero());
}

TEST_CASE(
    "given motion: the angular velocity of a row is that of the body, about any axis, but after whole turns")
{
    const Vec3 turn(0.4, 1.9, -0.7), spin(1.5, -0.3, 2.2);
    const std::optional<Vec3> rate = turn_rate(turn, spin);
    REQUIRE(rate);
    const GivenMotion motion =
        GivenMotion::through({{-1, Vec3::Zero(), Vec3::Zero()},
                              {0, Vec3::Zero(), turn, Vec3::Zero(), *rate, false, true},
                              {1, Vec3::Zero(), Vec3(0, 3, 0)}});
    CHECK((motion.at(0).angular_velocity - spin).norm() < 1e-12);
    const Quaternion change = motion.at(1e-6).rotation() * motion.at(-1e-6).rotation().conjugate();
    CHECK((2 * change.vec() / 2e-6 - spin).norm() < 1e-4);

    const Vec3 whole(0, 2 * std::numbers::pi, 0);
    CHECK(!turn_rate(whole, Vec3(1, 0, 0)));
    CHECK(!turn_rate(3 * whole, Vec3(0, 1, 1e-3)));
    const std::optional<Vec3> along = turn_rate(whole, Vec3(0, 5, 0));
    REQUIRE(along);
    CHECK((*along - Vec3(0, 5, 0)).norm() < 1e-12);
    CHECK((turn_rate(Vec3::Zero(), spin).value() - spin).norm() < 1e-15);
}

TEST_CASE("given motion: one that ends stands from then on where it has come to")
{
    GivenMotion steady = GivenMotion::steady({1, 2, 0}, {0, 3, 0}), table = uneven();
    steady.end_at(0.5);
    table.end_at(1.3);
    for (const double time : {0.5, 0.51, 7.0}) {
        CHECK((steady.at(time).displacement - Vec3(0.5, 1, 0)).norm() < 1e-15);
        CHECK((steady.at(time).turn - Vec3(0, 1.5, 0)).norm() < 1e-15);
        CHECK(steady.at(time).velocity == Vec3::Zero());
        CHECK(steady.at(time).angular_velocity == Vec3::Zero());
        CHECK(table.at(0.8 + time).displacement == uneven().at(1.3).displacement);
    }
    CHECK(steady.at(0.499).velocity == Vec3(1, 2, 0));
    CHECK(table.at(1.299).displacement == uneven().at(1.299).displacement);
}

TEST_CASE("given motion: about one axis the angle of a table may pass many turns")
{
    const GivenMotion motion = GivenMotion::through({{0, Vec3::Zero(), Vec3::Zero()},
                                                     {1, Vec3::Zero(), Vec3(0, 20, 0)},
                                                     {2, Vec3::Zero(), Vec3(0, 40, 0)}});
    CHECK((motion.at(1).angular_velocity - Vec3(0, 20, 0)).norm() < 1e-12);
    CHECK((motion.at(1.5).turn - Vec3(0, 32.5, 0)).norm() < 1e-12);  // 20 + 20/2 + 20/8
    CHECK_THROWS_AS(GivenMotion::through({{1, Vec3::Zero(), Vec3::Zero()}, {1, Vec3::Zero(), Vec3::Zero()}}),
                    std::invalid_argument);
    CHECK_THROWS_AS(GivenMotion::through({{1, Vec3::Zero(), Vec3::Zero()}}), std::invalid_argument);
}

TEST_CASE("driven body: two of them are where their motions say, by the world's time, whatever the step")
{
    for (const double dt : {0.01, 0.003, 0.1})
        for (const double start : {0.0, 0.7}) {
            CAPTURE(dt);
            CAPTURE(start);
            const GivenMotion table = uneven(), steady = GivenMotion::steady({1, 2, 3}, {0, 0.5, 0});
            World world;
            world.time = start;
            world.bodies.push_back(
                std::make_unique<DrivenBody>("table", placed_box(), Vec3(0.3, 0, 0), table, start));
            world.bodies.push_back(
                std::make_unique<DrivenBody>("steady", placed_box(), Vec3(0.3, 0, 0), steady, start));
            Contacts contacts;
            Solver solver;
            solver.max_halvings = 5;  // what turns fast is taken in parts
            for (int step = 0; step < 9; ++step)
                advance(world, contacts, solver, dt);
            const double end = start + 9 * dt;
            CHECK((world.bodies[0]->positions_t0()[0] - vertex_at(table, end)).norm() < 1e-12);
            CHECK((world.bodies[1]->positions_t0()[0] - vertex_at(steady, end)).norm() < 1e-12);
            const Vec3 placed = placed_box().vertices[0], centre(0.3, 0, 0);
            CHECK((vertex_at(steady, end) - centre - end * Vec3(1, 2, 3) -
                   Eigen::AngleAxisd(0.5 * end, Vec3::UnitY()) * (placed - centre))
                      .norm() < 1e-12);
            CHECK((dynamic_cast<const DrivenBody&>(*world.bodies[1])
                       .brought_back(world.bodies[1]->positions_t0()[0]) -
                   placed)
                      .norm() < 1e-12);
        }
}

TEST_CASE(
    "driven body: the velocity of a body that has turned by next to nothing follows the turn's change of axis")
{
    const Vec3 little(5e-5, 0, 0);  // at time 0, where it turns about another axis
    const GivenMotion motion = GivenMotion::through(
        {{-1, Vec3::Zero(), Vec3(0, -1, 0)}, {0, Vec3::Zero(), little}, {1, Vec3::Zero(), Vec3(0, 1, 0)}});
    constexpr double h = 1e-7;
    const Vec3 slope = (vertex_at(motion, h) - vertex_at(motion, -h)) / (2 * h);
    CHECK((DrivenBody("box", placed_box(), Vec3(0.3, 0, 0), motion).velocity(0) - slope).norm() < 1e-6);
}
