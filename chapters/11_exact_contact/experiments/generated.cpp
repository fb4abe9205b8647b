#include "chapters/11_exact_contact/experiments/experiments.hpp"
#include "chapters/11_exact_contact/experiments/generated_problems.hpp"
#include "chapters/11_exact_contact/force_memory.hpp"
#include "chapters/11_exact_contact/problem_of_step.hpp"
#include "common/experiments/report/growing_table.hpp"

#include <algorithm>

namespace enduring::chapter11 {

/// Problems that rules make, written for `scoreboard --problems` and for others, each with our answer, and
/// how they are solved.
void generated(const RunOptions& options, Report& report, unsigned set)
{
    GrowingTable table(report, "generated", {"problem", "contacts", "natural_map", "passes", "newton_steps"});
    long solved = 0, count = 0;
    std::string unsolved;
    for (const auto& [kind, named] : generated_problems(set)) {
        if (options.quick && named.problem.contacts() > most_quick_contacts)
            continue;
        const ExactSolution solution = solve_exactly(named.problem);
        write_file(report.file(named.name + ".dat"), siconos_text(named.problem));
        if (solution.solved())
            write_file(report.file(named.name + ".answer"), answer_text(solution.impulses));
        else
            unsolved.append(unsolved.empty() ? "" : ", ").append(named.name);
        table.add({named.name, static_cast<long>(named.problem.contacts()), solution.error,
                   static_cast<long>(solution.errors.size()), static_cast<long>(solution.newton_steps)});
        ++count;
        solved += solution.solved();
    }
    report.table("generated", table);
    report.fact("generated", "problems", static_cast<double>(count));
    report.fact("generated", "solved", static_cast<double>(solved));
    report.fact("generated", "unsolved", unsolved.empty() ? std::string("none") : unsolved);
}

}  // namespace enduring::chapter11
