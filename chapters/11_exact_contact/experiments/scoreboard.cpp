#include "chapters/11_exact_contact/experiments/experiments.hpp"
#include "chapters/11_exact_contact/experiments/solver_outcomes.hpp"
#include "chapters/11_exact_contact/force_memory.hpp"
#include "chapters/11_exact_contact/natural_map.hpp"
#include "common/experiments/report/progress.hpp"
#include "common/experiments/run/processor_clock.hpp"
#include "common/input/input_error.hpp"
#include "common/input/number_text.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <new>
#include <sstream>
#include <string>

namespace enduring::chapter11 {
namespace {

const std::array<std::string, 3> thresholds{"1e-4", "1e-6", "1e-8"};

//! [kept]
std::filesystem::path kept_file() { return public_problems() / "siconos.txt"; }

/// A line for each threshold, solver and problem: error, and time over ours.
std::string kept_text(const std::vector<NamedProblem>& problems, const std::vector<Outcomes>& of_thresholds)
{
    std::ostringstream out;
    for (std::size_t t = 0; t < thresholds.size(); ++t)
        for (const auto& [solver, outcomes] : of_thresholds[t])
            for (std::size_t i = 0; i < outcomes.size() && solver != "ours"; ++i)
                if (outcomes[i].error < never)
                    out << thresholds[t] << ' ' << solver << ' ' << problems[i].name << ' '
                        << outcomes[i].error << ' '
                        << outcomes[i].seconds / of_thresholds[t].at("ours")[i].seconds << '\n';
    return out.str();
}

/// Where Siconos is not installed: its outcomes as they were measured on Debian 12, its times by ours of
/// today.
void add_kept(const std::vector<NamedProblem>& problems, std::vector<Outcomes>& of_thresholds)
{
    std::ifstream file(kept_file());
    std::string threshold, solver, name;
    double error = 0, over_ours = 0;
    while (file >> threshold >> solver >> name >> error >> over_ours)
        for (std::size_t i = 0; i < problems.size(); ++i)
            if (problems[i].name == name) {
                Outcomes& all = of_thresholds[static_cast<std::size_t>(
                    std::find(thresholds.begin(), thresholds.end(), threshold) - thresholds.begin())];
                all[solver].resize(problems.size());
                all[solver][i] = {error, over_ours * all["ours"][i].seconds};
            }
}
//! [kept]

//! [profile]
/// Of all problems, the part that a solver brings below a threshold in at most so many times the time of the
/// best one.
double part_solved(const std::vector<Outcome>& solver, const Outcomes& all, double threshold, double factor)
{
    const auto time_of = [&](const Outcome& outcome) {
        return outcome.error <= threshold ? outcome.seconds : never;
    };
    double solved = 0;
    for (std::size_t i = 0; i < solver.size(); ++i) {
        double best = never;
        for (const auto& [name, outcomes] : all)
            best = std::min(best, time_of(outcomes[i]));
        solved += time_of(solver[i]) < never && time_of(solver[i]) <= factor * best;
    }
    return solved / static_cast<double>(solver.size());
}
//! [profile]

/// E. D. Dolan, J. J. More: Benchmarking optimization software with performance profiles, Mathematical
/// Programming 91, 2002.
Table profile(const std::vector<Outcomes>& of_thresholds)
{
    std::vector<std::string> columns{"time_over_best"};
    for (const std::string& threshold : thresholds)
        for (const auto& [solver, outcomes] : of_thresholds.front())
            columns.push_back(solver + "_" + threshold + "_percent");
    Table table(columns);
    for (const double factor : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 1000.0, 10000.0}) {
        std::vector<Cell> row{factor};
        for (std::size_t i = 0; i < thresholds.size(); ++i)
            for (const auto& [solver, outcomes] : of_thresholds[i])
                row.emplace_back(100 *
                                 part_solved(outcomes, of_thresholds[i], std::stod(thresholds[i]), factor));
        table.add(row);
    }
    return table;
}

Cell error_cell(const Outcomes& all, const std::string& solver, std::size_t problem)
{
    const auto found = all.find(solver);
    return found == all.end() || found->second[problem].error == never ? Cell("–")
                                                                       : Cell(found->second[problem].error);
}

Cell time_cell(const Outcomes& all, const std::string& solver, std::size_t problem)
{
    const auto found = all.find(solver);
    return found == all.end() || found->second[problem].seconds == never
               ? Cell("–")
               : Cell(1e3 * found->second[problem].seconds);
}

/// One solve on springs alone, as well as it goes.
double error_of_springs(const FrictionProblem& problem, double h)
{
    ExactSettings settings{.h = h, .keeps_h = true};
    settings.max_passes = 1;
    return solution_of(problem, settings).error;
}

std::vector<ExactSolution> solutions_of(const std::vector<NamedProblem>& problems)
{
    std::vector<ExactSolution> solutions;
    solutions.reserve(problems.size());
    for (const auto& [name, problem] : problems)
        solutions.push_back(solution_of(problem));
    return solutions;
}

/// How many problems in three dimensions there are and are solved, the worst by name, and the most steps.
void tell(Report& report, const std::string& which, const std::vector<NamedProblem>& problems,
          const std::vector<ExactSolution>& solutions)
{
    long count = 0, solved = 0;
    int most_steps = 0;
    double worst = 0;
    std::string worst_name;
    for (std::size_t i = 0; i < problems.size(); ++i) {
        const ExactSolution& solution = solutions[i];
        most_steps = std::max(most_steps, solution.newton_steps);
        if (problems[i].problem.dimension != 3)
            continue;
        ++count;
        solved += solution.solved();
        if (solution.error > worst) {
            worst = solution.error;
            worst_name = problems[i].name;
        }
    }
    report.fact("scoreboard", which + "_3d", static_cast<double>(count));
    report.fact("scoreboard", which + "_solved_1e8", static_cast<double>(solved));
    report.fact("scoreboard", which + "_worst_name", worst_name);
    report.fact("scoreboard", which + "_worst_error", worst, 3);
    report.fact("scoreboard", which + "_most_steps", most_steps);
}

/// Of the problems in three dimensions, those that each solver of Siconos solves; a dash where it is not
/// installed.
void tell_siconos(Report& report, const std::vector<NamedProblem>& problems, const Outcomes& sharp)
{
    for (const std::string& solver : siconos_solvers) {
        long solved = 0;
        for (std::size_t i = 0; i < problems.size(); ++i)
            solved += sharp.contains(solver) && sharp.at(solver)[i].error <= solved_error;
        report.fact("scoreboard", solver + "_solved", sharp.contains(solver) ? std::to_string(solved) : "–");
    }
}

/// @param sharp  what all solvers make of them when asked for 1e-8
Table table_of(const std::vector<NamedProblem>& problems, const std::vector<ExactSolution>& solutions,
               const Outcomes& sharp)
{
    Table table({"problem", "contacts", "springs_alone", "remembered", "sweeps", "passes", "newton_steps",
                 "NSGS", "Newton", "ADMM", "ours_ms", "NSGS_ms", "Newton_ms", "ADMM_ms"});
    for (std::size_t i = 0; i < problems.size(); ++i) {
        const FrictionProblem& problem = problems[i].problem;
        const ExactSolution& solution = solutions[i];
        std::vector<Cell> row{problems[i].name,
                              static_cast<long>(problem.contacts()),
                              error_of_springs(problem, 1e6),
                              solution.error,
                              static_cast<long>(solution.sweeps),
                              static_cast<long>(solution.errors.size()),
                              static_cast<long>(solution.newton_steps)};
        for (const std::string& solver : siconos_solvers)
            row.push_back(error_cell(sharp, solver, i));
        row.push_back(time_cell(sharp, "ours", i));
        for (const std::string& solver : siconos_solvers)
            row.push_back(time_cell(sharp, solver, i));
        table.add(std::move(row));
    }
    return table;
}

/// @throws InputError  no file of the folder could be read
ProblemFolder problems_in(const std::filesystem::path& folder)
{
    ProblemFolder read = read_problems(folder);
    for (const RefusedFile& refused : read.refused)
        std::cerr << refused.reason << '\n';
    if (read.problems.empty())
        throw InputError(folder.string() + ": has no problem that can be read");
    return read;
}

/// The same table with a row for each file that was refused, and why.
Table with_refused(const Table& table, const std::vector<RefusedFile>& refused)
{
    std::vector<std::string> columns = table.columns();
    columns.emplace_back("refused");
    Table all(columns);
    for (std::vector<Cell> row : table.rows()) {
        row.emplace_back("");
        all.add(std::move(row));
    }
    for (const RefusedFile& file : refused) {
        std::vector<Cell> row(columns.size(), Cell("–"));
        row.front() = file.name;
        row.back() = file.reason;
        all.add(std::move(row));
    }
    return all;
}

/// Tables of an earlier run are no tables of this one, which may end before it writes its own.
void take_away(Report& report, const std::string& name)
{
    for (const char* kind : {".csv", ".md"})
        std::filesystem::remove(report.folder() / (name + kind));
}

}  // namespace

/// The public problems that lie beside the chapter and our own, or those of another folder: springs alone,
/// springs that remember, and the solvers of Siconos, where it is installed.
void scoreboard(const RunOptions&, Report& report, const std::filesystem::path& more)
{
    const bool is_ours = more.empty();
    const std::string table_name = is_ours ? "scoreboard" : "yours",
                      profile_name = is_ours ? "profile" : "yours_profile";
    take_away(report, table_name);
    take_away(report, profile_name);
    const ProblemFolder folder = problems_in(is_ours ? public_problems() : more);
    const std::vector<NamedProblem>& given = folder.problems;
    const std::vector<NamedProblem> own = is_ours ? problems_in(own_problems()).problems
                                                  : std::vector<NamedProblem>{};
    std::vector<NamedProblem> all = given;
    all.insert(all.end(), own.begin(), own.end());
    std::vector<Outcomes> of_thresholds;
    for (const std::string& threshold : thresholds)
        of_thresholds.push_back(outcomes_for(all, std::stod(threshold)));
    if (of_thresholds.back().size() > 1 && is_ours)
        write_file(report.file("siconos.txt"), kept_text(all, of_thresholds));
    else if (is_ours)
        add_kept(all, of_thresholds);
    const std::vector<ExactSolution> solutions = solutions_of(given);
    Table table = table_of(given, solutions, of_thresholds.back());
    if (!is_ours)
        table = with_refused(table, folder.refused);
    const Table parts = profile(of_thresholds);
    report.table(table_name, table);
    report.page_table(table_name, table, 2);
    report.table(profile_name, parts);
    report.page_table(profile_name, parts, 3);
    if (!is_ours) {
        if (std::none_of(solutions.begin(), solutions.end(),
                         [](const ExactSolution& solution) { return solution.solved(); }))
            throw InputError(more.string() +
                             ": none of its problems was solved; the table says how far each one came");
        return;
    }
    report.plot("chapters/11_exact_contact/plots/profile.gp");
    tell(report, "public", given, solutions);
    tell(report, "own", own, solutions_of(own));
    tell_siconos(report, all, of_thresholds.back());
}

}  // namespace enduring::chapter11
