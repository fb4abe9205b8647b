#include "chapters/07_implicit_contact/experiments/experiments.hpp"
#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/experiments/rest_scenes.hpp"

#include <cmath>
#include <numbers>

namespace enduring::chapter07 {

/// A cube falls between two planes: from which angle on does it wedge itself in?
void wedged(const RunOptions&, Report& report)
{
    Table table({"half_angle_deg", "mu", "mu over tan", "unconverged", "solves", "worst_residual"});
    long locking_solves = 0, locking = 0, other_solves = 0, other = 0;
    for (const double mu : {0.2, 0.5})
        for (const double half_angle_deg : {10, 15, 20, 25, 30, 35, 40}) {
            Scene scene = cube_between_planes(half_angle_deg, mu, 0.01);
            const SolveStatistics solves = watch(scene, 3).solves;
            const double lock = mu / std::tan(half_angle_deg * std::numbers::pi / 180);
            table.add({half_angle_deg, mu, lock, solves.unconverged, solves.solves, solves.worst_residual});
            (lock > 1 ? locking : other) += solves.unconverged;
            (lock > 1 ? locking_solves : other_solves) += solves.solves;
        }
    report.table("wedged", table);
    report.page_table("wedged", table, 2);
    report.fact("wedged", "locking_percent",
                100.0 * static_cast<double>(locking) / static_cast<double>(locking_solves), 2);
    report.fact("wedged", "other_percent",
                100.0 * static_cast<double>(other) / static_cast<double>(other_solves), 2);
}

}  // namespace enduring::chapter07
