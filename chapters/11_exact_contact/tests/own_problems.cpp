#include "chapters/11_exact_contact/experiments/problem_folder.hpp"
#include "chapters/11_exact_contact/experiments/siconos_scores.hpp"
#include "chapters/11_exact_contact/force_memory.hpp"
#include "chapters/11_exact_contact/natural_map.hpp"
#include "chapters/11_exact_contact/problem_file.hpp"
#include "chapters/11_exact_contact/problem_of_step.hpp"
#include "common/experiments/report/report.hpp"
#include "common/experiments/report/tests/temporary_folder.hpp"
#include "common/input/json_document.hpp"
#include "common/input/source_directory.hpp"

#include <doctest/doctest.h>

#include <sys/wait.h>
#include <cstdlib>
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

/// What Siconos answers to a file of bodies: nothing where Siconos is not installed, one number where it does
/// not solve it.
Eigen::VectorXd siconos_answer(const std::filesystem::path& problem, const FrictionProblem& read)
{
    const TemporaryFolder folder;
    const std::filesystem::path script = source_directory() /
                                         "chapters/11_exact_contact/tests/solve_by_siconos.py",
                                output = folder.path / "answer";
    const std::string command = "/usr/bin/python3 '" + script.string() + "' '" + problem.string() + "' " +
                                std::to_string(read.bodies->mass.rows()) + " > '" + output.string() +
                                "' 2> /dev/null";
    const int status = std::system(command.c_str());
    if (WIFEXITED(status) && (WEXITSTATUS(status) == 3 || WEXITSTATUS(status) == 127))
        return {};
    Eigen::VectorXd impulses = Eigen::VectorXd::Constant(1, -1);
    if (status != 0)
        return impulses;
    impulses.resize(read.free_velocity.size());
    std::ifstream file(output);
    for (double& x : impulses)
        file >> x;
    return impulses;
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

TEST_CASE("own problems: Siconos, where it is installed, reads our text and solves it")
{
    for (const char* name : {"cube_at_rest_1.dat", "cube_slides_on_slope_2.dat", "heap_of_8_30.dat"}) {
        CAPTURE(name);
        // written anew: the writer is tested, and not the file that lies there
        const FrictionProblem problem = read_problem(chapter11::own_problems() / name);
        const TemporaryFolder folder;
        write_file(folder.path / name, siconos_text(problem));
        const Eigen::VectorXd theirs = siconos_answer(folder.path / name, problem);
        if (theirs.size() == 0) {
            MESSAGE("Siconos is not installed (on Debian 12: ./course setup siconos)");
            return;
        }
        REQUIRE(theirs.size() == problem.free_velocity.size());
        CHECK(natural_map_error(problem, theirs) <= 1e-7);
        CHECK(siconos_text(problem) == read_text_file(chapter11::own_problems() / name));
    }
}
