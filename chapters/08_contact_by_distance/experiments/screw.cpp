#include "chapters/08_contact_by_distance/experiments/bolt.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::chapter08 {

/// A bolt without friction turns down through its nut.
void screw(const RunOptions& options, Report& report)
{
    Table table({"segments", "bolt_segments", "flank", "dt_s", "fallen_mm", "by_energy_mm", "aside_mm",
                 "energy_gain_j", "pairs", "edge_pairs"});
    double apart = 0, with_short_steps = 0, gain = 0;
    long solves = 0, unconverged = 0;
    const std::vector<double> steps = options.quick ? std::vector{0.01, 0.0025}
                                                    : std::vector{0.01, 0.0025, 0.001};
    for (const double flank : {0.577, 0.3})
        for (const auto& [segments, bolt_segments] : {std::pair(96, 84), {192, 170}})
            for (const double dt : steps) {
                if (options.quick && segments > 96)
                    continue;
                BoltInNut bolt{.segments = segments, .bolt_segments = bolt_segments, .dt = dt};
                bolt.thread.flank = flank;
                const BoltFall fall = drop_bolt(bolt);
                table.add({static_cast<long>(segments), static_cast<long>(bolt_segments), flank, dt,
                           fall.fallen_mm, fall.by_energy_mm, fall.aside_mm, fall.energy_gain_j, fall.pairs,
                           fall.edge_pairs});
                const double percent = 100 * std::abs(fall.fallen_mm / fall.by_energy_mm - 1);
                apart = std::max(apart, percent);
                with_short_steps = dt <= 0.0025 ? std::max(with_short_steps, percent) : with_short_steps;
                gain = std::max(gain, fall.energy_gain_j);
                solves += fall.solves.solves;
                unconverged += fall.solves.unconverged;
            }
    report.table("screw", table);
    report.page_table("screw", table, 4);
    report.fact("screw", "runs", static_cast<double>(table.rows().size()));
    report.fact("screw", "apart_percent", apart, 2);
    report.fact("screw", "short_steps_percent", with_short_steps, 2);
    report.fact("screw", "energy_gain_j", gain, 2);
    report.fact("screw", "solves", static_cast<double>(solves));
    report.fact("screw", "unconverged", static_cast<double>(unconverged));
}

}  // namespace enduring::chapter08
