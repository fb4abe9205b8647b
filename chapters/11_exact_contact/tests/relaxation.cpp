#include "chapters/11_exact_contact/relaxation.hpp"

#include "chapters/11_exact_contact/experiments/experiments.hpp"
#include "chapters/11_exact_contact/force_memory.hpp"
#include "chapters/11_exact_contact/natural_map.hpp"
#include "chapters/11_exact_contact/solver.hpp"
#include "chapters/11_exact_contact/tests/one_block.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace enduring;

TEST_CASE(
    "relaxation: Coulomb's rule by projection is what pencil and paper find, and the relaxation lifts what slides")
{
    for (const HandSolved& block : hand_solved_blocks()) {
        CAPTURE(block.name);
        CHECK((projected_impulses(block.problem, FrictionRule::coulomb) - block.impulse).norm() <= 1e-10);
        const Eigen::VectorXd relaxed = projected_impulses(block.problem, FrictionRule::relaxed);
        const Eigen::VectorXd velocity = contact_velocities(block.problem, relaxed);
        const double slip = std::hypot(velocity[1], velocity[2]);
        if (block.name == "slides")
            CHECK(velocity[0] == doctest::Approx(block.problem.mu[0] * slip));
        else
            CHECK((relaxed - block.impulse).norm() <= 1e-10);
    }
}

TEST_CASE(
    "relaxation: a block that slides floats at mu v dt, and under Coulomb's rule it stays on the ground")
{
    for (const double mu : {0.2, 0.7})
        for (const double dt : {0.001, 0.01}) {
            SlidingBlock floats{mu * 3 * dt, 3, 0}, stays{0, 3, 0};
            for (int step = 0; step < 5; ++step) {
                floats = after_step(floats, mu, dt, FrictionRule::relaxed);
                stays = after_step(stays, mu, dt, FrictionRule::coulomb);
                CHECK(floats.gap == doctest::Approx(mu * floats.speed * dt));
                CHECK(std::abs(stays.gap) <= 1e-12);
                CHECK(stays.speed == doctest::Approx(3 - mu * 9.81 * dt * (step + 1)));
            }
            // one that lies on the ground is thrown up by what it slides: r_n = g dt + mu u_t and u_t = v -
            // mu r_n
            const SlidingBlock thrown = after_step({0, 3, 0}, mu, dt, FrictionRule::relaxed);
            CHECK(thrown.rising == doctest::Approx(mu * (3 - mu * 9.81 * dt) / (1 + mu * mu)));
        }
}

TEST_CASE(
    "relaxation: a rod that slides is stopped at once from Painleve's friction on, which is least 4/3 at tan a = 2")
{
    double least = 10;
    for (int i = 1; i < 1000; ++i)
        least = std::min(least, painleve_friction(i * std::numbers::pi / 2000));
    CHECK(least == doctest::Approx(4.0 / 3).epsilon(1e-5));
    CHECK(painleve_friction(std::atan(2.0)) == doctest::Approx(4.0 / 3));
    for (const double part : {0.9, 1.1}) {
        const FrictionProblem rod = sliding_rod(std::atan(2.0), part * 4 / 3, 1, 0.0981);
        const ExactSolution solution = solve_exactly(rod);
        CAPTURE(part);
        CHECK(solution.solved());
        CHECK(std::isfinite(solution.impulses[0]));
    }
    const FrictionProblem jams = sliding_rod(std::atan(2.0), 1.1 * 4 / 3, 1, 0.0981);
    const Eigen::VectorXd velocity = contact_velocities(jams, solve_exactly(jams).impulses);
    CHECK(velocity.norm() <= 1e-6);
}

TEST_CASE("relaxation: beyond Painleve's friction a rod that leaves the ground has two exact answers")
{
    const FrictionProblem rod = sliding_rod(std::atan(2.0), 2, 1, -0.01);
    const Eigen::VectorXd flies = Eigen::VectorXd::Zero(2),
                          stops = -Eigen::MatrixXd(rod.response).inverse() * rod.free_velocity;
    CHECK(natural_map_error(rod, flies) <= 1e-14);
    CHECK(natural_map_error(rod, stops) <= 1e-14);
    CHECK(stops[0] > 0.1);
    CHECK(solve_exactly(rod).impulses.norm() <= 1e-9);  // begins at none
}

TEST_CASE(
    "relaxation: a rod of a scene jams in its first step, by an impulse that no shorter step makes smaller")
{
    const double angle = std::atan(2.0), critical = painleve_friction(angle);
    for (const double dt : {1e-3, 1e-4}) {
        CAPTURE(dt);
        for (const double part : {0.5, 1.1}) {
            Scene scene = chapter11::rod_scene(angle, part * critical, dt);
            const Solver solver = chapter11_solver(scene.contact);
            Contacts contacts;
            advance(scene.world, contacts, solver, dt);
            double impulse = 0;
            for (const Contact& contact : contacts)
                impulse += contact.impulse.norm();
            // what stops the end's slip of 1 m/s alone: W r = -q, with det W = 4
            const double jam = 0.75 * std::sin(angle) * std::cos(angle);
            if (part > 1)
                CHECK(impulse == doctest::Approx(jam).epsilon(0.05));
            else
                CHECK(impulse < 20 * dt);
        }
    }
}
