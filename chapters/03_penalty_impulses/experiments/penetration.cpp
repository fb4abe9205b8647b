#include "chapters/01_particle_plane/particle.hpp"
#include "chapters/03_penalty_impulses/experiments/bar_drop.hpp"
#include "chapters/03_penalty_impulses/experiments/experiments.hpp"
#include "chapters/03_penalty_impulses/experiments/jitter.hpp"
#include "common/experiments/report/growing_table.hpp"

#include <cmath>

namespace enduring::chapter03 {
namespace {

constexpr std::array<PenaltyMethod, 2> both_methods{PenaltyMethod::discrete, PenaltyMethod::continuous};

/// Figure 7.6: the mean summed depth along k dt^2 = const, where both
/// methods are equally close to their limit.
void depth_over_step(const std::filesystem::path& file, Report& report)
{
    Table table({"elements", "dt_s", "stiffness_n_per_m", "dpf_depth_mm", "cpf_depth_mm", "ratio"});
    for (const std::string& basis : both_bases)
        for (const double dt : {0.003, 0.004, 0.005, 0.006, 0.007, 0.008, 0.010}) {
            const DepthRatio depth = depths_between_limits(file, dt, basis);
            table.add({basis, dt, stiffness_between_limits(dt), 1000 * depth.discrete,
                       1000 * depth.continuous, depth.ratio()});
        }
    report.table("depth_over_step", table);
    report.page_table("depth_over_step", table, 3);
    report.plot("chapters/03_penalty_impulses/plots/depth_over_step.gp");
}

/// What each method can do without jitter.
struct Best {
    double stiffness = 0, depth = 0;
};

/// One method over the stiffness, from soft to hard, at the step of figure 7.7.
Best over_stiffness(const RunOptions& options, const std::filesystem::path& file, BarDrop drop,
                    GrowingTable& table)
{
    constexpr double smooth = 0.003;
    Best best;
    bool over = false;  // below the first smooth stiffness the bar sinks too deep to lie still
    for (int i = 0; i <= 14; i += options.quick ? 4 : 1) {
        drop.stiffness = std::round(2000 * std::pow(2, i / 6.0));
        std::vector<double> depths, jitters, pairs;
        for (const double turn : nine_turns(options.quick)) {
            drop.turn_deg = turn;
            const BarRecord record = drop_bar(file, drop);
            depths.push_back(depth_at_rest(record));
            jitters.push_back(jitter_at_rest(record));
            pairs.push_back(pairs_at_rest(record));
        }
        over = over || (best.stiffness > 0 && median(jitters) >= smooth);
        if (!over && median(jitters) < smooth)
            best = {drop.stiffness, median(depths)};
        table.add({drop.basis, short_name(drop.method), drop.stiffness, 1000 * median(depths),
                   100 * median(jitters), median(pairs), median(pairs) * drop.stiffness});
    }
    return best;
}

/// Figure 7.7: depth and jitter over the stiffness, at one step.
void depth_over_stiffness(const RunOptions& options, const std::filesystem::path& file, Report& report)
{
    GrowingTable table(
        report, "depth_over_stiffness",
        {"elements", "method", "stiffness_n_per_m", "depth_mm", "jitter_percent", "pairs", "nk_n_per_m"},
        4 * (options.quick ? 4 : 15));
    Table summary({"elements", "method", "largest smooth k [N/m]", "summed depth there [mm]",
                   "thesis k [N/m]", "thesis depth [mm]"});
    for (const std::string& basis : both_bases)
        for (const PenaltyMethod method : both_methods) {
            const bool discrete = method == PenaltyMethod::discrete, of_thesis = basis == "quadratic";
            const Best best = over_stiffness(options, file, {method, 0.01, 0, 45, basis}, table);
            summary.add({basis, short_name(method), best.stiffness, 1000 * best.depth,
                         of_thesis ? discrete ? "3000" : "7000 and 8000" : "-",
                         of_thesis ? discrete ? "280" : "100" : "-"});
            report.fact("penetration", basis + (discrete ? "_dpf_best_mm" : "_cpf_best_mm"),
                        1000 * best.depth, 3);
            report.fact("penetration", basis + (discrete ? "_dpf_best_k" : "_cpf_best_k"), best.stiffness, 3);
        }
    report.table("depth_over_stiffness", table);
    report.plot("chapters/03_penalty_impulses/plots/depth_over_stiffness.gp");
    report.table("best_without_jitter", summary);
    report.page_table("best_without_jitter", summary, 4);
}

}  // namespace

void penetration(const RunOptions& options, Report& report)
{
    const std::filesystem::path file = options.scene.value_or(scene_file("bar_on_cube"));
    depth_over_step(file, report);
    depth_over_stiffness(options, file, report);
}

}  // namespace enduring::chapter03
