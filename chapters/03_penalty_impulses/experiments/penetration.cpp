#include "experiments.hpp"

#include "bar_drop.hpp"
#include "chapters/01_particle_plane/particle.hpp"
#include "common/simulation/progress.hpp"
#include "jitter.hpp"

#include <cmath>

namespace enduring::chapter03 {
namespace {

constexpr std::array<PenaltyMethod, 2> both_methods{PenaltyMethod::discrete, PenaltyMethod::continuous};

/// Figure 7.6: the mean summed depth along k dt^2 = const, where both methods are equally close to their limit.
void depth_over_step(const std::filesystem::path& file, Report& report)
{
    Table table({"dt_s", "stiffness_n_per_m", "dpf_depth_mm", "cpf_depth_mm", "ratio"});
    for (const double dt : {0.004, 0.006, 0.008, 0.010, 0.012, 0.016, 0.020}) {
        const double stiffness = std::round(5000 * std::pow(0.0095 / dt, 2));
        const double dpf = depth_in_contact(drop_bar(file, {PenaltyMethod::discrete, dt, stiffness}));
        const double cpf = depth_in_contact(drop_bar(file, {PenaltyMethod::continuous, dt, stiffness}));
        table.add({dt, stiffness, 1000 * dpf, 1000 * cpf, cpf / dpf});
    }
    report.table("depth_over_step", table);
    report.page_table("depth_over_step", table, 3);
    report.plot("chapters/03_penalty_impulses/plots/depth_over_step.gp");
}

/// What each method can do without jitter.
struct Best {
    double stiffness = 0, depth = 0;
};

/// Figure 7.7: depth and jitter over the stiffness, at one step.
void depth_over_stiffness(const RunOptions& options, const std::filesystem::path& file, Report& report)
{
    constexpr double dt = 0.01, smooth = 0.003;
    const int count = options.quick ? 5 : 17, spacing = options.quick ? 2000 : 500;
    Table table({"method", "stiffness_n_per_m", "depth_mm", "jitter_percent", "pairs", "nk_n_per_m"});
    std::array<Best, 2> best{};
    Progress progress("penetration: over the stiffness", 2 * count);
    for (std::size_t m = 0; m < 2; ++m) {
        bool still_smooth = true;
        for (int i = 0; i < count; ++i) {
            const double stiffness = 2000 + spacing * i;
            std::vector<double> depths, jitters, pairs;
            for (const double turn : nine_turns(options.quick)) {
                const BarRecord record = drop_bar(file, {both_methods[m], dt, stiffness, turn});
                depths.push_back(depth_at_rest(record));
                jitters.push_back(jitter_at_rest(record));
                pairs.push_back(pairs_at_rest(record));
            }
            still_smooth = still_smooth && median(jitters) < smooth;
            if (still_smooth)
                best[m] = {stiffness, median(depths)};
            table.add({short_name(both_methods[m]), stiffness, 1000 * median(depths), 100 * median(jitters), median(pairs),
                       median(pairs) * stiffness});
            progress.update(static_cast<int>(m) * count + i + 1);
        }
    }
    report.table("depth_over_stiffness", table);
    report.plot("chapters/03_penalty_impulses/plots/depth_over_stiffness.gp");

    Table summary({"method", "largest smooth k [N/m]", "summed depth there [mm]", "thesis k [N/m]", "thesis depth [mm]"});
    summary.add({"DPF", best[0].stiffness, 1000 * best[0].depth, 3000l, 280l});
    summary.add({"CPF", best[1].stiffness, 1000 * best[1].depth, "7000 and 8000", 100l});
    report.table("best_without_jitter", summary);
    report.page_table("best_without_jitter", summary, 4);
    report.fact("penetration", "dpf_best_mm", 1000 * best[0].depth, 3);
    report.fact("penetration", "cpf_best_mm", 1000 * best[1].depth, 3);
}

}  // namespace

void penetration(const RunOptions& options, Report& report)
{
    const std::filesystem::path file = options.scene.value_or(scene_file("bar_on_cube"));
    depth_over_step(file, report);
    depth_over_stiffness(options, file, report);
}

}  // namespace enduring::chapter03
