#include "chapters/11_exact_contact/experiments/problem_folder.hpp"
#include "chapters/11_exact_contact/experiments/siconos_scores.hpp"
#include "chapters/11_exact_contact/force_memory.hpp"
#include "chapters/11_exact_contact/natural_map.hpp"
#include "chapters/11_exact_contact/problem_file.hpp"

#include <doctest/doctest.h>

#include <fstream>

using namespace enduring;

namespace {

/// The numbers of an answer's file; with one more or less than asked for none at all.
Eigen::VectorXd published_answer(const std::string& problem, Eigen::Index numbers)
{
    std::ifstream file(chapter11::own_problems() / (problem.substr(0, problem.rfind('.')) + ".answer"));
    Eigen::VectorXd answer(numbers);
    for (double& x : answer)
        file >> x;
    double more = 0;
    return file && !(file >> more) ? answer : Eigen::VectorXd();
}

}  // namespace

TEST_CASE("own problems: each published answer is exact for its file, and nothing near it is")
{
    const chapter11::ProblemFolder folder = chapter11::read_problems(chapter11::own_problems());
    CHECK(folder.refused.empty());
    CHECK(folder.problems.size() >= 40);
    for (const auto& [name, problem] : folder.problems) {
        CAPTURE(name);
        const Eigen::VectorXd answer = published_answer(name, 3 * problem.contacts());
        REQUIRE(answer.size() == 3 * problem.contacts());
        CHECK(natural_map_error(problem, answer) <= 1e-8);
        CHECK(natural_map_error(problem, 0.999 * answer) >= 1e-6);
    }
}

TEST_CASE("own problems: each is solved from where nothing pushes, with fewer steps than the bound")
{
    for (const auto& [name, problem] : chapter11::read_problems(chapter11::own_problems()).problems) {
        CAPTURE(name);
        const ExactSolution solution = solve_exactly(problem);
        CHECK(solution.solved());
        CHECK(solution.newton_steps < ExactSettings{}.max_newton_steps);
    }
}

TEST_CASE("own problems: Siconos is given the same W, in blocks, also where W is not symmetric")
{
    FrictionProblem problem = read_problem(chapter11::public_problems() / "Rover1040.dat");
    problem.bodies.reset();
    const FrictionProblem read = parse_siconos(chapter11::blocks_text(problem), "blocks.dat");
    CHECK((Eigen::MatrixXd(read.response) - Eigen::MatrixXd(problem.response)).isZero(0));
    CHECK_FALSE(
        Eigen::MatrixXd(read.response - Eigen::SparseMatrix<double>(read.response.transpose())).isZero(0));
    CHECK(read.free_velocity == problem.free_velocity);
    CHECK(read.mu == problem.mu);
}
