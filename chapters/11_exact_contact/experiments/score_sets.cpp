#include "chapters/11_exact_contact/experiments/experiments.hpp"
#include "chapters/11_exact_contact/experiments/generated_problems.hpp"
#include "chapters/11_exact_contact/experiments/solver_outcomes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace enduring::chapter11 {
namespace {

constexpr double threshold = solved_error;
/// From so many contacts on a solver's set-up no longer decides its time.
constexpr int many_contacts = 20;

std::vector<NamedProblem> in_space(std::vector<NamedProblem> problems, int most_contacts)
{
    std::erase_if(problems, [&](const NamedProblem& named) {
        return named.problem.dimension != 3 || named.problem.contacts() > most_contacts;
    });
    return problems;
}

std::vector<NamedProblem> of_rules(unsigned set)
{
    std::vector<NamedProblem> problems;
    for (GeneratedProblem& generated : generated_problems(set))
        problems.push_back(std::move(generated.named));
    return problems;
}

Cell solved(const Outcomes& all, const std::string& solver)
{
    const auto found = all.find(solver);
    if (found == all.end())
        return Cell("–");
    return static_cast<long>(std::count_if(found->second.begin(), found->second.end(),
                                           [](const Outcome& one) { return one.error <= threshold; }));
}

//! [geometric_mean]
/// Our time over a solver's, as a geometric mean over the problems that both solve; a dash where there are
/// none.
Cell our_time_over(const std::vector<NamedProblem>& problems, const Outcomes& all, const std::string& solver,
                   int least_contacts)
{
    const auto found = all.find(solver);
    if (found == all.end())
        return Cell("–");
    double sum = 0;
    long count = 0;
    for (std::size_t i = 0; i < problems.size(); ++i) {
        const Outcome &ours = all.at("ours")[i], &theirs = found->second[i];
        if (problems[i].problem.contacts() < least_contacts || ours.error > threshold ||
            theirs.error > threshold || !(theirs.seconds > 0) || !(ours.seconds > 0))
            continue;
        sum += std::log(ours.seconds / theirs.seconds);
        ++count;
    }
    return count > 0 ? Cell(std::exp(sum / static_cast<double>(count))) : Cell("–");
}
//! [geometric_mean]

void tell(Report& report, const std::string& name, const Cell& cell)
{
    if (const auto* const text = std::get_if<std::string>(&cell))
        report.fact("score_sets", name, *text);
    else if (const auto* const count = std::get_if<long>(&cell))
        report.fact("score_sets", name, static_cast<double>(*count));
    else
        report.fact("score_sets", name, std::get<double>(cell), 2);
}

}  // namespace

Table scores_of(const std::vector<NamedSet>& sets)
{
    Table table({"set", "problems", "ours", "NSGS", "Newton", "ADMM", "time_over_NSGS", "time_over_Newton",
                 "time_over_NSGS_from_20", "time_over_Newton_from_20"});
    for (const auto& [name, problems] : sets) {
        const Outcomes outcomes = outcomes_for(problems, threshold);
        std::vector<Cell> row{name, static_cast<long>(problems.size())};
        for (const char* solver : {"ours", "NSGS", "Newton", "ADMM"})
            row.push_back(solved(outcomes, solver));
        for (const int least : {1, many_contacts})
            for (const char* solver : {"NSGS", "Newton"})
                row.push_back(our_time_over(problems, outcomes, solver, least));
        table.add(std::move(row));
    }
    return table;
}

/// How many problems of each set the solvers bring to 1e-8, and our time over theirs: public ones, our
/// scenes', those of rules on which the solver was tried, those of the same rules on which it was not, and
/// those of a folder of yours.
void score_sets(const RunOptions& options, Report& report, const std::filesystem::path& more, unsigned set)
{
    constexpr int most_quick = 10;  // contacts
    std::vector<NamedSet> sets{{"public", read_problems(public_problems()).problems},
                               {"our_scenes", read_problems(own_problems()).problems},
                               {"rules_tried", of_rules(0)},
                               {"rules_held_out", of_rules(set)}};
    if (!more.empty())
        sets.emplace_back("yours", read_problems(more).problems);
    for (auto& [name, problems] : sets)
        problems = in_space(std::move(problems),
                            options.quick ? most_quick : std::numeric_limits<int>::max());
    const Table table = scores_of(sets);
    for (const std::vector<Cell>& row : table.rows())
        for (std::size_t i = 1; i < row.size(); ++i)
            tell(report, std::get<std::string>(row[0]) + "_" + table.columns()[i], row[i]);
    report.table("score_sets", table);
    report.page_table("score_sets", table, 2);
}

}  // namespace enduring::chapter11
