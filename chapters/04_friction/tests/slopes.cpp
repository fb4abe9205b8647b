#include "chapters/03_penalty_impulses/solver.hpp"
#include "chapters/04_friction/experiments/launch.hpp"
#include "chapters/04_friction/experiments/spring_energy.hpp"
#include "chapters/04_friction/experiments/tilting.hpp"
#include "chapters/04_friction/experiments/turning.hpp"
#include "chapters/04_friction/friction_contact.hpp"
#include "chapters/04_friction/solver.hpp"
#include "common/experiments/render/reference.hpp"
#include "common/experiments/render/renderer.hpp"
#include "common/experiments/render/scene_view.hpp"
#include "common/experiments/run/run.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace enduring;
using namespace enduring::chapter04;

namespace {

double tangent(double degrees) { return std::tan(degrees * std::numbers::pi / 180); }

const MassSplitting mass_splitting{.spring = 20000};

YamaneNakamura printed(double spring, double damper) { return {.spring = spring, .damper = damper}; }

Launch launch(double angle_deg, double dt, const FrictionParameters& friction)
{
    Launch it;
    it.angle_deg = angle_deg;
    it.dt = dt;
    it.friction = friction;
    return it;
}

Progress1d after(Scene& scene, const Solver& solver, double seconds)
{
    RunLimits limits;
    limits.steps = static_cast<int>(std::lround(seconds / scene.dt));
    run(scene, solver, {}, limits);
    return along_slope(scene.world, 10);
}

}  // namespace

TEST_CASE("slope: chapter 3 slides back for ever where friction holds")
{
    Scene smooth = load_scene(scene_file("block_on_slope")), rough = load_scene(scene_file("block_on_slope"));
    const Progress1d slid = after(smooth, chapter03_solver(smooth.contact), 4),
                     held = after(rough, chapter04_solver(rough.contact), 4);
    CHECK(slid.speed == doctest::Approx(3 - 9.81 * std::sin(std::numbers::pi / 18) * 4).epsilon(1e-3));
    CHECK(std::abs(held.speed) < 1e-3);
    CHECK(held.way ==
          doctest::Approx(
              9 / (2 * 9.81 * (std::sin(std::numbers::pi / 18) + 0.1 * std::cos(std::numbers::pi / 18))))
              .epsilon(0.02));
}

TEST_CASE("threshold: mass-splitting friction holds within 5 % of the angle's tangent, and lets go below it")
{
    for (const double angle : {5.0, 10.0, 20.0, 30.0})
        for (const double dt : {0.01, 0.002}) {
            CAPTURE(angle);
            CAPTURE(dt);
            CHECK(holds(launch(angle, dt, with_mu_s(mass_splitting, 1.05 * tangent(angle)))));
            CHECK_FALSE(holds(launch(angle, dt, with_mu_s(mass_splitting, 0.99 * tangent(angle)))));
        }
}

TEST_CASE("threshold: the thesis' model overshoots what it has to hold, the less damped the further")
{
    const double critical = 2 * std::sqrt(4 * 5000.0 * 100) / 4;  // of one pair, n = 4
    const double little = smallest_mu_s(launch(10, 0.002, printed(5000, 0.05 * critical)));
    const double half = smallest_mu_s(launch(10, 0.002, printed(5000, 0.5 * critical)));
    const double twice = smallest_mu_s(launch(10, 0.002, printed(5000, 2 * critical)));
    CHECK(little / tangent(10) > 1.75);
    CHECK(little / tangent(10) < 2.25);
    CHECK(half / tangent(10) == doctest::Approx(1.33).epsilon(0.06));
    CHECK(twice / tangent(10) < 1.12);
}

TEST_CASE("slope: mass-splitting friction slides with g (sin -+ mu_d cos) within 1 %, up and down")
{
    for (const double angle : {5.0, 30.0})
        for (const double dt : {0.01, 0.002}) {
            const Launch it = launch(angle, dt, with_mu_s(mass_splitting, 0.8 * tangent(angle)));
            const Vec3 up = uphill(angle);
            const double mu_d = std::get<MassSplitting>(it.friction).mu_d;
            CHECK(mean_acceleration(it, 2.5, 0.5) ==
                  doctest::Approx(-9.81 * (up.y() + mu_d * up.x())).epsilon(0.01));
            CHECK(mean_acceleration(it, -0.5, -2.5) ==
                  doctest::Approx(-9.81 * (up.y() - mu_d * up.x())).epsilon(0.01));
        }
}

TEST_CASE("slope: with mass-splitting friction the energy of bodies and springs never rises")
{
    for (const double height : {0.1, 1.0})
        for (const double angle : {5.0, 30.0})
            for (const double dt : {0.01, 0.002}) {
                CAPTURE(height);
                CAPTURE(angle);
                CAPTURE(dt);
                Launch it = launch(angle, dt, with_mu_s(mass_splitting, 1.2 * tangent(angle)));
                it.height = height;
                Scene scene = scene_of(it);
                SpringEnergyProbe energy("", scene.contact);
                run(scene, chapter04_solver(scene.contact), {&energy});
                CHECK(energy.largest_rise() < 1e-6 * 450);  // of the 450 J that it starts with
            }
}

TEST_CASE("tilting: a block and a cube slide at the angle of friction within 5 %")
{
    for (const double height : {0.1, 1.0}) {
        const double angle = sliding_angle(height, 0.01, with_mu_s(mass_splitting, tangent(20)));
        CHECK(tangent(20) / tangent(angle) == doctest::Approx(1).epsilon(0.05));
    }
}

TEST_CASE("turning: friction opposes the slip within a degree while its direction turns")
{
    const TurnRecord record = drive_in_circles({});
    CHECK(record.worst_angle_deg < 1);
    double least_x = 0, most_x = 0;  // it did turn
    for (const std::vector<Cell>& row : record.table.rows()) {
        least_x = std::min(least_x, std::get<double>(row[3]));
        most_x = std::max(most_x, std::get<double>(row[3]));
    }
    CHECK(least_x < -0.5);
    CHECK(most_x > 0.5);
}

TEST_CASE("drift: a block held on a slope stays where it is, to a micrometre over 15,000 steps")
{
    Scene scene = load_scene(scene_file("block_on_slope"));
    const Solver solver = chapter04_solver(scene.contact);
    Contacts contacts;
    double early = 0;
    for (int step = 1; step <= 20000; ++step) {
        advance(scene.world, contacts, solver, scene.dt);
        if (step == 5000)
            early = along_slope(scene.world, 10).way;
    }
    CHECK(std::abs(along_slope(scene.world, 10).way - early) < 1e-6);
}

TEST_CASE("tilting: a soft bar on a tilted plane is held above the angle of friction and slides below it")
{
    for (const std::string response : {"lumped", "implicit"})
        for (const bool held : {true, false}) {
            CAPTURE(response);
            CAPTURE(held);
            Scene scene = load_scene(
                scene_file("block_on_slope"),
                R"({"gravity": [-2, -9.6, 0], "contact": {"stiffness": 5000}, "planes": [{"name": "floor"}], "bodies": [
                {"name": "bar", "type": "deformable", "basis": "linear", "shape": {"bar": {"size": [1, 0.2, 0.5], "cells": [4, 1, 2]}}, "mass": 100,
                 "young": 1e6, "poisson": 0.3, "rayleigh": {"stiffness": 0.01}, "position": [0, 0.087, 0], "impulse_response": ")" +
                    response + R"("}]})");
            scene.contact.friction = with_mu_s(MassSplitting{.spring = 5000}, (held ? 1.2 : 0.6) * 2 / 9.6);
            // A lumped push that moves one node strains its elements by more than the work it did.
            run(scene, chapter04_solver(scene.contact), {}, {.may_gain_energy = response == "lumped"});
            const double speed = scene.world.bodies[0]->linear_momentum().x() / 100;
            if (held)
                CHECK(std::abs(speed) < 1e-3);
            else
                CHECK(speed ==
                      doctest::Approx(-4 * (2 - 9.6 * std::get<MassSplitting>(scene.contact.friction).mu_d))
                          .epsilon(0.05));
        }
}

TEST_CASE("mesh: on a slope of triangles the block hooks within a cell, where on the plane it slides on")
{
    Scene scene = load_scene(scene_file("block_on_triangles"));
    double start = 0, farthest = 0;
    WatchProbe watch([&](const World& world, const Contacts&, double) {
        Vec3 middle = Vec3::Zero();
        for (const Vec3& x : world.bodies[1]->positions_t0())
            middle += x / 8;
        if (world.step == 0)
            start = middle.dot(uphill(10));
        farthest = std::max(farthest, middle.dot(uphill(10)) - start);
    });
    run(scene, chapter04_solver(scene.contact), {&watch});
    CHECK(farthest < 12.0 / 16);
}

TEST_CASE(
    "errata: with the printed constants of 7.3 the cube sticks at almost 3 m/s, and mu_s = 0.3 holds it in the end")
{
    Launch it = launch(10, 0.01, printed(100, 25));
    it.friction = with_coefficients(it.friction, 0.3, 0.1);
    double stuck_at = 0, way = 0;
    Scene scene = scene_of(it);
    const Solver solver = chapter04_solver(scene.contact);
    Contacts contacts;
    while (scene.world.time < 40) {
        advance(scene.world, contacts, solver, scene.dt);
        const Progress1d now = along_slope(scene.world, 10);
        if (stuck_at == 0 && contacts.size() == 4 && contacts[0].spring.slip == 0)
            stuck_at = now.speed;
        way = now.way;
    }
    CHECK(stuck_at == doctest::Approx(2.9).epsilon(0.03));
    CHECK(way > -10);
    // Read as an impulse whose velocity is the way of one step, they do what figure 7.15 shows.
    for (const auto& [mu_s, stays] : {std::pair(0.3, false), std::pair(0.4, true)}) {
        it.friction = with_coefficients(printed(100 / it.dt, 25), mu_s, 0.1);
        double last = 0;
        follow(it, 4, [&](const Progress1d& now) {
            last = now.way;
            return true;
        });
        CHECK((last > 1) == stays);
    }
}

TEST_CASE("slope scene: the cube and its friction as in their reference picture" *
          doctest::skip(!pictures_are_on))
{
    Scene scene = load_scene(scene_file("slope"), R"({"duration": 0.6})");
    const RunResult result = run(scene, chapter04_solver(scene.contact));
    Stage stage = stage_of(scene.world, scene);
    mark_contacts(stage, scene.world, result.contacts);
    const ReferenceCheck check = check_reference_picture(Renderer(480, 320).draw(stage),
                                                         "04_friction/slope.png");
    CHECK_MESSAGE(check.passed, check.message);
}
