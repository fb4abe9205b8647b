#include "chapters/07_implicit_contact/experiments/rest_runs.hpp"
#include "chapters/07_implicit_contact/experiments/rest_scenes.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/experiments/report/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter08 {
namespace {

struct Gap {
    double half_angle_deg, mu, dt;
};

std::vector<Gap> all_gaps(bool quick)
{
    std::vector<double> steps{0.01, 1.0 / 60, 0.002};
    if (quick)
        steps = {0.01};
    std::vector<Gap> gaps;
    for (const double dt : steps)
        for (const double mu : {0.2, 0.5, 1.0})
            for (const double half_angle_deg : {10, 15, 20, 25, 30, 35, 40})
                gaps.push_back({half_angle_deg, mu, dt});
    return gaps;
}

}  // namespace

/// A cube falls between two planes: from which angle on does it wedge itself in, and does it come to rest?
void wedged(const RunOptions& options, Report& report)
{
    const std::vector<Gap> gaps = all_gaps(options.quick);
    const auto outcomes = sweep<chapter07::PileOutcome>(options, "wedged", gaps.size(), [&](std::size_t i) {
        Scene scene = chapter07::cube_between_planes(gaps[i].half_angle_deg, gaps[i].mu, gaps[i].dt);
        return chapter07::watch(scene, 3, chapter08_solver);
    });
    if (!outcomes)
        return;
    Table table({"half_angle_deg", "mu", "mu over tan", "dt_s", "at_rest", "deepest_mm", "max_newton_steps",
                 "unconverged", "solves"});
    long locking_runs = 0, locking_at_rest = 0, other_runs = 0, other_at_rest = 0, solves = 0,
         unconverged = 0;
    double deepest_mm = 0;
    for (std::size_t i = 0; i < gaps.size(); ++i) {
        const Gap& gap = gaps[i];
        const chapter07::PileOutcome& outcome = (*outcomes)[i];
        const bool rests = chapter07::is_at_rest(outcome);
        const double lock = gap.mu / std::tan(gap.half_angle_deg * std::numbers::pi / 180);
        table.add({gap.half_angle_deg, gap.mu, lock, gap.dt, rests ? "yes" : "no", outcome.deepest_mm,
                   static_cast<long>(outcome.solves.max_newton_steps), outcome.solves.unconverged,
                   outcome.solves.solves});
        ++(lock > 1 ? locking_runs : other_runs);
        (lock > 1 ? locking_at_rest : other_at_rest) += rests;
        solves += outcome.solves.solves;
        unconverged += outcome.solves.unconverged;
        deepest_mm = std::max(deepest_mm, outcome.deepest_mm);
    }
    report.table("wedged", table);
    report.page_table("wedged", table, 2);
    report.fact("wedged", "locking_runs", static_cast<double>(locking_runs));
    report.fact("wedged", "locking_at_rest", static_cast<double>(locking_at_rest));
    report.fact("wedged", "other_runs", static_cast<double>(other_runs));
    report.fact("wedged", "other_at_rest", static_cast<double>(other_at_rest));
    report.fact("wedged", "solves", static_cast<double>(solves));
    report.fact("wedged", "unconverged", static_cast<double>(unconverged));
    report.fact("wedged", "deepest_mm", deepest_mm, 2);
}

}  // namespace enduring::chapter08
