#include "chapters/11_exact_contact/problem_of_step.hpp"

#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/11_exact_contact/force_memory.hpp"
#include "chapters/11_exact_contact/natural_map.hpp"
#include "chapters/11_exact_contact/problem_file.hpp"
#include "chapters/11_exact_contact/solver.hpp"
#include "chapters/11_exact_contact/tests/one_block.hpp"
#include "common/experiments/report/tests/temporary_folder.hpp"
#include "common/input/json_document.hpp"
#include "common/scenes/scene.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <sstream>

using namespace enduring;

namespace {

/// The impulses that a step has found, as its problem has them.
Eigen::VectorXd impulses_of(const World& world, const Contacts& contacts)
{
    Eigen::VectorXd impulses(static_cast<Eigen::Index>(3 * contacts.size()));
    for (std::size_t i = 0; i < contacts.size(); ++i)
        impulses.segment<3>(static_cast<Eigen::Index>(3 * i)) =
            contact_frame(contact_geometry(world, contacts[i], 0).normal) *
            (contacts[i].impulse + contacts[i].friction);
    return impulses;
}

/// Steps of a scene under chapter 11's solver, which writes its problems.
Contacts run_and_write(Scene& scene, int steps, const std::filesystem::path& folder)
{
    Solver solver = chapter11_solver(scene.contact);
    write_problems(solver, scene.contact, folder);
    Contacts contacts;
    for (int step = 0; step < steps; ++step)
        advance(scene.world, contacts, solver, scene.dt);
    return contacts;
}

}  // namespace

TEST_CASE("problem of a step: what is written is read as the same problem")
{
    for (const HandSolved& block : hand_solved_blocks()) {
        const FrictionProblem read = parse_siconos(siconos_text(block.problem), "block.dat");
        CHECK((Eigen::MatrixXd(read.response) - Eigen::MatrixXd(block.problem.response)).isZero(0));
        CHECK(read.free_velocity == block.problem.free_velocity);
        CHECK(read.mu == block.problem.mu);
    }
    Scene scene = chapter07::scene_of(chapter07::stack_of(2), 0.01, 10);
    const TemporaryFolder folder;
    run_and_write(scene, 1, folder.path);
    const FrictionProblem once = read_problem(folder.path / "step_000001.dat");
    const FrictionProblem twice = parse_siconos(siconos_text(once), "again.dat");
    REQUIRE(once.bodies.has_value());
    REQUIRE(twice.bodies.has_value());
    CHECK((Eigen::MatrixXd(once.response) - Eigen::MatrixXd(twice.response)).isZero(0));
    CHECK(once.free_velocity == twice.free_velocity);
    CHECK(once.mu == twice.mu);
}

TEST_CASE("problem of a step: the impulses of a step are an exact answer to its written problem")
{
    Scene scene = chapter07::scene_of(chapter07::stack_of(3), 0.01, 10);
    const TemporaryFolder folder;
    const Contacts contacts = run_and_write(scene, 20, folder.path);
    const FrictionProblem problem = read_problem(folder.path / "step_000020.dat");
    REQUIRE(static_cast<std::size_t>(problem.contacts()) == contacts.size());
    const Eigen::VectorXd impulses = impulses_of(scene.world, contacts);
    CHECK(natural_map_error(problem, impulses) <= 1e-5);
    // and not an exact answer to anything near it
    CHECK(natural_map_error(problem, 0.99 * impulses) >= 1e-3);
    const ExactSolution solution = solve_exactly(problem);
    CHECK(solution.solved());
    CHECK((problem.bodies->levers * (solution.impulses - impulses)).norm() <=
          1e-4 * (problem.bodies->levers * impulses).norm());
}

TEST_CASE("problem of a step: a stack of which only W is known is solved by springs that begin soft, too")
{
    Scene scene = chapter07::scene_of(chapter07::stack_of(8, 10, 1000), 0.01);
    const TemporaryFolder folder;
    run_and_write(scene, 1, folder.path);
    FrictionProblem problem = read_problem(folder.path / "step_000001.dat");
    problem.bodies.reset();
    for (const double h : {1e1, 1e2, 1e10}) {
        CAPTURE(h);
        CHECK(solve_exactly(problem, {.h = h}).solved());
    }
}

TEST_CASE("problem of a step: a matrix says that it comes from triplets, as Siconos asks")
{
    // Siconos counts where a sparse matrix comes from: 1 is triplets, and any other number ends its program
    CHECK(siconos_text(hand_solved_blocks()[0].problem).find("\n3 3\n1\nCSparse") != std::string::npos);
}

TEST_CASE("problem of a step: its answer stands beside it")
{
    Scene scene = chapter07::scene_of(chapter07::stack_of(2), 0.01, 10);
    const TemporaryFolder folder;
    run_and_write(scene, 1, folder.path);
    const FrictionProblem problem = read_problem(folder.path / "step_000001.dat");
    const std::string text = read_text_file(folder.path / "step_000001.answer");
    CHECK(text == answer_text(solve_exactly(problem).impulses));
    std::istringstream words(text);
    Eigen::VectorXd answer(problem.free_velocity.size());
    for (double& x : answer)
        words >> x;
    CHECK(words);
    CHECK(natural_map_error(problem, answer) <= 1e-8);
}

TEST_CASE("problem of a step: a gap counts as the velocity that closes it in the step")
{
    Scene scene = chapter07::scene_of({{10, Vec3(0, 0.5001, 0)}}, 0.01);
    const TemporaryFolder folder;
    run_and_write(scene, 1, folder.path);
    const FrictionProblem problem = read_problem(folder.path / "step_000001.dat");
    for (int i = 0; i < problem.contacts(); ++i)
        CHECK(problem.free_velocity[3 * i] == doctest::Approx(-9.81 * 0.01 + 1e-4 / 0.01));
}

TEST_CASE("problem of a step: a soft body on the ground is pushed by its weight")
{
    const char* const text = R"({"name": "soft", "dt": 0.01, "duration": 1, "planes": [{"name": "ground"}],
        "contact": {"friction": {"model": "mass_splitting", "mu_s": 0.5, "mu_d": 0.4}},
        "bodies": [{"name": "bar", "type": "deformable", "shape": {"bar": {"size": [1, 1, 1], "cells": [1, 1, 1]}},
                    "mass": 10, "young": 1e6, "poisson": 0.3, "position": [0, 0.5, 0]}]})";
    const TemporaryFolder folder;
    write_file(folder.path / "soft.json", text);
    Scene scene = load_scene(folder.path / "soft.json");
    run_and_write(scene, 1, folder.path / "problems");
    const FrictionProblem problem = read_problem(folder.path / "problems/step_000001.dat");
    const ExactSolution solution = solve_exactly(problem);
    CHECK(solution.solved());
    CHECK(problem.contacts() >= 4);
    double sum = 0;
    for (int i = 0; i < problem.contacts(); ++i)
        sum += solution.impulses[3 * i];
    CHECK(sum > 0);
}
