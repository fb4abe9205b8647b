#include "chapters/07_implicit_contact/experiments/spinning_box.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/experiments/report/growing_table.hpp"

#include <algorithm>
#include <limits>
#include <map>

namespace enduring::chapter08 {

/// Boxes that turn far in a step land on a box: with whole steps, and with steps in parts.
void spinning(const RunOptions& options, Report& report)
{
    constexpr double whole = std::numeric_limits<double>::infinity();
    const unsigned seeds = options.quick ? 10 : 50;
    GrowingTable table(report, "spinning",
                       {"turn_rad", "most turn", "runs", "gain", "max_energy", "unconverged", "solves"},
                       6 * 4);
    std::map<double, double> most_of;  // by the most turn, of all runs
    for (const double turn : {0.2, 0.5, 1.0, 2.0, 3.0, 6.0})
        for (const double max_turn : {whole, 1.0, 0.5, 0.25}) {
            chapter07::SolveStatistics solves;
            long gains = 0;
            double most = 0;
            for (unsigned seed = 1; seed <= seeds; ++seed) {
                const double dt = seed % 2 == 0 ? 0.01 : 1.0 / 60;
                const double energy = chapter07::max_energy(chapter07::spinning_box(turn, dt, seed),
                                                            chapter08_solver, max_turn, solves);
                gains += energy > 1.001;
                most = std::max(most, energy);
            }
            table.add({turn, max_turn == whole ? Cell("whole steps") : Cell(max_turn),
                       static_cast<long>(seeds), gains, most, solves.unconverged, solves.solves});
            most_of[max_turn] = std::max(most_of[max_turn], most);
        }
    report.table("spinning", table);
    report.page_table("spinning", table, 2);
    report.fact("spinning", "whole_most", most_of[whole], 2);
    report.fact("spinning", "parts_gain", std::max(0.0, most_of[0.5] - 1), 1);
}

}  // namespace enduring::chapter08
