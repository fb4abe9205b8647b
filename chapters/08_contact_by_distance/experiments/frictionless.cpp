#include "chapters/07_implicit_contact/experiments/soft_scenes.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/experiments/soft_slide.hpp"
#include "chapters/08_contact_by_distance/experiments/swings.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace enduring::chapter08 {
namespace {

/// A kind of swing over ever finer facets.
struct Refined {
    std::string name;
    std::string in;
    Swing swing;
};

std::vector<Refined> all_swings(bool quick)
{
    std::vector<Refined> swings;
    const std::vector<double> steps = quick ? std::vector{0.01, 0.0025}
                                            : std::vector{0.01, 0.005, 0.0025, 0.001};
    for (const double dt : steps) {
        for (const int facets : {60, 120, 480})
            swings.push_back({"block", "half pipe of " + std::to_string(facets), block_in_pipe(facets, dt)});
        swings.push_back({"ball", "bowl of 24 x 8", ball_in_bowl(24, 8, dt)});
        if (!quick && dt > 0.001)
            swings.push_back({"ball", "bowl of 96 x 32", ball_in_bowl(96, 32, dt)});
    }
    for (const double dt : quick ? std::vector{0.0025} : std::vector{0.0025, 0.001}) {
        for (const int facets : quick ? std::vector{60} : std::vector{60, 240, 960})
            swings.push_back({"block", "torus of " + std::to_string(facets), block_in_torus(facets, dt)});
        if (!quick)
            for (const int facets : {24, 960})
                swings.push_back(
                    {"block", "half pipe of " + std::to_string(facets), block_in_pipe(facets, dt)});
    }
    if (!quick)
        swings.push_back({"ball", "bowl of 192 x 64", ball_in_bowl(192, 64, 0.0025)});
    return swings;
}

/// The largest departures of some swings [%].
struct Apart {
    double all = 0, with_short_steps = 0;

    void add(double percent, double dt)
    {
        all = std::max(all, std::abs(percent));
        if (dt <= 0.0025)
            with_short_steps = std::max(with_short_steps, std::abs(percent));
    }
};

void swing_all(bool quick, Report& report)
{
    Table table({"body", "in", "dt_s", "kept_percent", "inelastic_percent", "period_over_pendulum",
                 "deepest_mm", "pairs", "edge_pairs"});
    std::map<std::string, Apart> apart;
    Apart period;
    std::map<std::string, std::pair<double, double>> finest;  // of pipe, torus and bowl: kept and period [%]
    chapter07::SolveStatistics solves;
    for (Refined& one : all_swings(quick)) {
        const double dt = one.swing.scene.dt;
        const SwingOutcome outcome = watch_swing(one.swing);
        const double bound = inelastic_bound(one.swing);
        const double mean = 0.5 * one.swing.amplitude * (1 + outcome.kept);
        const double over = outcome.period_s / pendulum_period(one.swing, mean);
        table.add({one.name, one.in, dt, 100 * outcome.kept, 100 * bound, over, outcome.deepest_mm,
                   outcome.pairs, outcome.edge_pairs});
        const std::string round = one.in.substr(0, one.in.find(" of"));
        finest[round.substr(round.find(' ') + 1)] = {100 * outcome.kept,
                                                     100 * std::abs(over - 1)};  // the last is the finest
        apart[one.name].add(100 * (outcome.kept / bound - 1), dt);
        period.add(100 * (over - 1), dt);
        solves.solves += outcome.solves.solves;
        solves.unconverged += outcome.solves.unconverged;
    }
    report.table("frictionless_swings", table);
    report.page_table("frictionless_swings", table, 4);
    report.fact("frictionless", "swings", static_cast<double>(table.rows().size()));
    for (const auto& [body, percent] : apart) {
        report.fact("frictionless", body + "s_apart_percent", percent.all, 2);
        report.fact("frictionless", body + "s_short_steps_percent", percent.with_short_steps, 2);
    }
    for (const auto& [round, percent] : finest) {
        report.fact("frictionless", round + "_kept_percent", percent.first, 4);
        report.fact("frictionless", round + "_period_percent", percent.second, 2);
    }
    report.fact("frictionless", "period_percent", period.all, 2);
    report.fact("frictionless", "solves", static_cast<double>(solves.solves));
    report.fact("frictionless", "unconverged", static_cast<double>(solves.unconverged));
}

void slide_soft_cubes(bool quick, Report& report)
{
    const std::vector<int> cells = quick ? std::vector{2, 3} : std::vector{2, 3, 5};
    const std::vector<double> steps = quick ? std::vector{0.01} : std::vector{0.01, 0.005, 0.0025, 0.001};
    Table table({"cells", "young_pa", "dt_s", "speed_m_per_s", "by_formula_m_per_s", "kept_percent"});
    double lost = 0;
    for (const int along : cells)
        for (const double young : {1e5, 1e7})
            for (const double dt : steps) {
                const SoftSlide slide = slide_without_friction({along, young, dt, 100}, 1.5);
                const double kept = slide.speed / slide.by_formula;
                table.add({static_cast<long>(along), young, dt, slide.speed, slide.by_formula, 100 * kept});
                lost = std::max(lost, std::abs(kept - 1));
            }
    report.table("frictionless_soft", table);
    report.page_table("frictionless_soft", table, 5);
    report.fact("frictionless", "soft_apart_percent", 100 * lost, 2);
}

}  // namespace

/// Bodies that slide without friction over concave edges: they lose what an inelastic body has to lose.
void frictionless(const RunOptions& options, Report& report)
{
    swing_all(options.quick, report);
    slide_soft_cubes(options.quick, report);
}

}  // namespace enduring::chapter08
