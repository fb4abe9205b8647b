#include "chapters/11_exact_contact/experiments/solver_outcomes.hpp"

#include "chapters/11_exact_contact/natural_map.hpp"
#include "common/experiments/report/progress.hpp"
#include "common/experiments/run/processor_clock.hpp"
#include "common/input/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <new>

namespace enduring::chapter11 {
namespace {

/// Of a threshold, what every solver is asked for.
constexpr double asked = 0.1;

/// The least of three runs, unless they are long.
Outcome timed(const FrictionProblem& problem, const ExactSettings& settings)
{
    Outcome outcome;
    for (int run = 0; run < 3; ++run) {
        const double begin = processor_seconds();
        outcome.error = solution_of(problem, settings).error;
        const double seconds = processor_seconds() - begin;
        outcome.seconds = std::min(outcome.seconds, seconds);
        if (seconds > 0.05)
            break;
    }
    return outcome;
}

}  // namespace

ExactSolution solution_of(const FrictionProblem& problem, const ExactSettings& settings)
{
    try {
        return solve_exactly(problem, settings);
    } catch (const std::bad_alloc&) {
        ExactSolution none;
        none.error = never;
        return none;
    }
}

Outcomes outcomes_for(const std::vector<NamedProblem>& problems, double threshold)
{
    Outcomes all;
    std::vector<Outcome>& ours = all["ours"];
    ours.reserve(problems.size());
    Progress progress("", static_cast<long>(problems.size()), " problems to " + shortest(threshold));
    for (const auto& [name, problem] : problems) {
        ours.push_back(timed(problem, {.tolerance = asked * threshold}));
        progress.update(static_cast<long>(ours.size()));
    }
    for (const SiconosAnswer& answer : solve_by_siconos(problems, asked * threshold)) {
        std::vector<Outcome>& theirs = all[answer.solver];
        theirs.resize(problems.size());
        const double error = natural_map_error(problems[answer.problem].problem, answer.impulses);
        theirs[answer.problem] = {std::isfinite(error) ? error : never, answer.seconds};
    }
    return all;
}

}  // namespace enduring::chapter11
