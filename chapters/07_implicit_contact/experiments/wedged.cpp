#include "chapters/07_implicit_contact/experiments/experiments.hpp"
#include "chapters/07_implicit_contact/experiments/rest_runs.hpp"
#include "chapters/07_implicit_contact/experiments/rest_scenes.hpp"
#include "common/experiments/report/growing_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter07 {

/// A cube falls between two planes: from which angle on does it wedge itself in, and does it come to rest?
void wedged(const RunOptions& options, Report& report)
{
    std::vector<double> steps{0.01, 1.0 / 60, 0.002};
    if (options.quick)
        steps = {0.01};
    GrowingTable table(report, "wedged",
                       {"half_angle_deg", "mu", "mu over tan", "dt_s", "at_rest", "deepest_mm",
                        "most_newton_steps", "unconverged", "solves"},
                       steps.size() * 3 * 7);
    long locking_runs = 0, locking_at_rest = 0, other_runs = 0, other_at_rest = 0, solves = 0,
         unconverged = 0;
    double deepest_mm = 0;
    for (const double dt : steps)
        for (const double mu : {0.2, 0.5, 1.0})
            for (const double half_angle_deg : {10, 15, 20, 25, 30, 35, 40}) {
                Scene scene = cube_between_planes(half_angle_deg, mu, dt);
                const PileOutcome outcome = watch(scene, 3);
                const bool rests = is_at_rest(outcome);
                const double lock = mu / std::tan(half_angle_deg * std::numbers::pi / 180);
                table.add({half_angle_deg, mu, lock, dt, rests ? "yes" : "no", outcome.deepest_mm,
                           static_cast<long>(outcome.solves.most_newton_steps), outcome.solves.unconverged,
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

}  // namespace enduring::chapter07
