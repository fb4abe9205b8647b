#include "chapters/11_exact_contact/experiments/experiments.hpp"
#include "chapters/11_exact_contact/experiments/problem_folder.hpp"
#include "chapters/11_exact_contact/force_memory.hpp"
#include "common/experiments/report/growing_table.hpp"

#include <algorithm>
#include <array>
#include <iostream>
#include <limits>
#include <string>

namespace enduring::chapter11 {
namespace {

constexpr std::array thresholds{1e-4, 1e-6, 1e-8};

struct Score {
    std::string name;
    int dimension;
    ExactSolution solution;
};

/// One solve on springs alone, as well as it goes.
double error_of_springs(const FrictionProblem& problem, double h)
{
    ExactSettings settings{.h = h, .keeps_h = true, .first_residual = 1e-10};
    settings.max_passes = 1;
    return solve_exactly(problem, settings).error;
}

/// Newton's steps after which a problem's error was below a threshold for the first time.
double steps_until(const ExactSolution& solution, double threshold)
{
    double steps = 0;
    for (std::size_t pass = 0; pass < solution.errors.size(); ++pass) {
        steps += solution.steps[pass];
        if (solution.errors[pass] <= threshold)
            return steps;
    }
    return std::numeric_limits<double>::infinity();
}

/// How many of all problems are solved with so many steps of Newton's method.
Table profile(const std::vector<Score>& scores)
{
    Table table({"newton_steps", "to_1e-4_percent", "to_1e-6_percent", "to_1e-8_percent"});
    for (const long steps : {1L, 2L, 5L, 10L, 20L, 50L, 100L, 200L, 500L, 1000L}) {
        std::vector<Cell> row{steps};
        for (const double threshold : thresholds) {
            const auto solved = std::count_if(scores.begin(), scores.end(), [&](const Score& score) {
                return steps_until(score.solution, threshold) <= static_cast<double>(steps);
            });
            row.emplace_back(100.0 * static_cast<double>(solved) / static_cast<double>(scores.size()));
        }
        table.add(row);
    }
    return table;
}

void tell(Report& report, const std::vector<Score>& scores)
{
    const auto solved = [&](int dimension, double threshold) {
        return std::count_if(scores.begin(), scores.end(), [&](const Score& score) {
            return score.dimension == dimension && score.solution.error <= threshold;
        });
    };
    const auto number = [&](const std::string& name, auto value) {
        report.fact("scoreboard", name, static_cast<double>(value), 3);
    };
    number("problems_3d", solved(3, std::numeric_limits<double>::infinity()));
    number("problems_2d", solved(2, std::numeric_limits<double>::infinity()));
    number("solved_1e4", solved(3, 1e-4));
    number("solved_1e6", solved(3, 1e-6));
    number("solved_1e8", solved(3, 1e-8));
    const auto worst = std::max_element(
        scores.begin(), scores.end(),
        [](const Score& one, const Score& other) { return one.solution.error < other.solution.error; });
    report.fact("scoreboard", "worst_name", worst->name);
    number("worst_error", worst->solution.error);
    number("most_steps",
           std::max_element(scores.begin(), scores.end(), [](const Score& one, const Score& other) {
               return one.solution.newton_steps < other.solution.newton_steps;
           })->solution.newton_steps);
}

}  // namespace

/// The public problems that lie beside the chapter, or those of another folder: springs alone at three stiffnesses, and springs
/// that remember.
void scoreboard(const RunOptions&, Report& report, const std::filesystem::path& more)
{
    const ProblemFolder folder = read_problems(more.empty() ? own_problems() : more);
    for (const std::string& refused : folder.refused)
        std::cerr << refused << '\n';
    if (folder.problems.empty())
        return;
    GrowingTable table(report, more.empty() ? "scoreboard" : "yours",
                       {"problem", "contacts", "dimension", "springs_h_1e4", "springs_h_1e6", "springs_h_1e8",
                        "remembered", "passes", "newton_steps"},
                       folder.problems.size());
    std::vector<Score> scores;
    for (const auto& [name, problem] : folder.problems) {
        const ExactSolution solution = solve_exactly(problem);
        table.add({name, static_cast<long>(problem.contacts()), static_cast<long>(problem.dimension),
                   error_of_springs(problem, 1e4), error_of_springs(problem, 1e6),
                   error_of_springs(problem, 1e8), solution.error, static_cast<long>(solution.errors.size()),
                   static_cast<long>(solution.newton_steps)});
        scores.push_back({name, problem.dimension, solution});
    }
    if (!more.empty()) {  // the book's tables are those of the chapter's own problems
        report.table("yours", table);
        report.page_table("yours", table, 2);
        report.table("yours_profile", profile(scores));
        return;
    }
    report.table("scoreboard", table);
    report.page_table("scoreboard", table, 2);
    report.table("profile", profile(scores));
    report.page_table("profile", profile(scores), 3);
    report.plot("chapters/11_exact_contact/plots/profile.gp");
    tell(report, scores);
}

}  // namespace enduring::chapter11
