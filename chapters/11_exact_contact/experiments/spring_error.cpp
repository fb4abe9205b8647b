#include "chapters/11_exact_contact/experiments/experiments.hpp"
#include "chapters/11_exact_contact/experiments/problem_folder.hpp"
#include "chapters/11_exact_contact/force_memory.hpp"
#include "chapters/11_exact_contact/problem_file.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace enduring::chapter11 {
namespace {

/// Every pass is solved as well as it can be, so that what is left is the spring's.
ExactSolution after_passes(const FrictionProblem& problem, double h, int passes)
{
    ExactSettings settings{.h = h, .keeps_h = true, .tolerance = 0};
    settings.max_passes = passes;
    return solve_exactly(problem, settings);
}

/// A block of 2 kg that is pressed onto the ground and held by friction: W = 1 / (2 kg).
FrictionProblem block_that_holds()
{
    FrictionProblem problem;
    problem.response.resize(3, 3);
    problem.response.setIdentity();
    problem.response *= 0.5;
    problem.free_velocity = Vec3(-1, 0.3, 0.4);
    problem.mu = Eigen::VectorXd::Constant(1, 0.6);
    return problem;
}

/// The error of one solve at h = 1e3, and how much smaller each pass makes it.
void tell(Report& report, const std::string& which, const FrictionProblem& problem)
{
    const ExactSolution solution = after_passes(problem, 1e3, 3);
    report.fact("spring_error", which + "_one_solve", solution.errors.front(), 2);
    report.fact("spring_error", which + "_per_pass", solution.errors.front() / solution.errors[1], 3);
}

}  // namespace

/// One block, and 54 contacts: the natural map of springs over h, after one solve and after more that
/// remember.
void spring_error(const RunOptions&, Report& report)
{
    const FrictionProblem block = block_that_holds(),
                          many = read_problem(public_problems() / "Confeti-ex03-Fc3D-SBM.dat");
    Table table({"h", "block", "block_2_passes", "block_4_passes", "many", "many_2_passes", "many_4_passes",
                 "many_8_passes"});
    double best_alone = 1, best_of_many = 1;
    for (int power = 0; power <= 20; ++power) {
        const double h = std::pow(10, 0.5 * power);
        std::vector<Cell> row{h};
        for (const int passes : {1, 2, 4})
            row.emplace_back(after_passes(block, h, passes).error);
        for (const int passes : {1, 2, 4, 8}) {
            const double error = after_passes(many, h, passes).error;
            row.emplace_back(error);
            double& best = passes == 1 ? best_alone : best_of_many;
            best = std::min(best, error);
        }
        table.add(row);
    }
    report.table("spring_error", table);
    report.plot("chapters/11_exact_contact/plots/spring_error.gp");
    tell(report, "block", block);
    tell(report, "many", many);
    report.fact("spring_error", "best_alone", best_alone, 2);
    report.fact("spring_error", "best_of_many", best_of_many, 2);
}

}  // namespace enduring::chapter11
