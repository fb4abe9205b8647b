#include "chapters/01_particle_plane/particle.hpp"
#include "chapters/03_penalty_impulses/experiments/bar_drop.hpp"
#include "chapters/03_penalty_impulses/experiments/experiments.hpp"
#include "common/experiments/report/sweep.hpp"

#include <array>
#include <cmath>

namespace enduring::chapter03 {
namespace {

constexpr std::array<PenaltyMethod, 2> dpf_and_cpf{PenaltyMethod::discrete, PenaltyMethod::continuous};

/// Figure 7.6: the mean summed depth along k dt^2 = const, where both
/// methods are equally close to their limit.
void depth_over_step(const RunOptions& options, const std::filesystem::path& file, Report& report)
{
    const std::vector<double> steps = options.quick
                                          ? std::vector{0.003, 0.005, 0.007, 0.010}
                                          : std::vector{0.003, 0.004, 0.005, 0.006, 0.007, 0.008, 0.010};
    const auto depths = sweep<DepthRatio>(
        options, "depth_over_step", both_bases.size() * steps.size(), [&](std::size_t i) {
            return depths_between_limits(file, steps[i % steps.size()], both_bases[i / steps.size()]);
        });
    if (!depths)
        return;
    Table table({"elements", "dt_s", "stiffness_n_per_m", "dpf_depth_mm", "cpf_depth_mm", "ratio"});
    for (std::size_t i = 0; i < depths->size(); ++i) {
        const double dt = steps[i % steps.size()];
        const DepthRatio& depth = (*depths)[i];
        table.add({both_bases[i / steps.size()], dt, stiffness_between_limits(dt), 1000 * depth.discrete,
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

/// One stiffness after the other, from soft to hard, at the step of figure 7.7.
std::vector<double> all_stiffnesses(bool quick)
{
    std::vector<double> all;
    for (int i = 0; i <= 14; i += quick ? 4 : 1)
        all.push_back(std::round(2000 * std::pow(2, i / 6.0)));
    return all;
}

/// One method over the stiffness.
/// @param outcomes  one for each stiffness
Best add_over_stiffness(const BarDrop& drop, const std::vector<double>& stiffnesses,
                        const NineDrops* outcomes, Table& table)
{
    constexpr double smooth = 0.003;
    Best best;
    bool over = false;  // below the first smooth stiffness the bar sinks too deep to lie still
    for (std::size_t i = 0; i < stiffnesses.size(); ++i) {
        const NineDrops& of = outcomes[i];
        over = over || (best.stiffness > 0 && of.jitter >= smooth);
        if (!over && of.jitter < smooth)
            best = {stiffnesses[i], of.depth};
        table.add({drop.basis, short_name(drop.method), stiffnesses[i], 1000 * of.depth, 100 * of.jitter,
                   of.pairs, of.pairs * stiffnesses[i]});
    }
    return best;
}

/// Figure 7.7: depth and jitter over the stiffness, at one step.
void depth_over_stiffness(const RunOptions& options, const std::filesystem::path& file, Report& report)
{
    const std::vector<double> stiffnesses = all_stiffnesses(options.quick);
    const std::size_t of_basis = dpf_and_cpf.size() * stiffnesses.size(),
                      count = both_bases.size() * of_basis;
    const auto outcomes = sweep<NineDrops>(options, "depth_over_stiffness", count, [&](std::size_t i) {
        const PenaltyMethod method = dpf_and_cpf[i % of_basis / stiffnesses.size()];
        BarDrop drop{method, 0.01, stiffnesses[i % stiffnesses.size()], 45, both_bases[i / of_basis]};
        return drop_nine_times(file, drop, options.quick);
    });
    if (!outcomes)
        return;
    Table table(
        {"elements", "method", "stiffness_n_per_m", "depth_mm", "jitter_percent", "pairs", "nk_n_per_m"});
    Table summary({"elements", "method", "largest smooth k [N/m]", "summed depth there [mm]",
                   "thesis k [N/m]", "thesis depth [mm]"});
    const NineDrops* next = outcomes->data();
    for (const std::string& basis : both_bases)
        for (const PenaltyMethod method : dpf_and_cpf) {
            const bool discrete = method == PenaltyMethod::discrete, of_thesis = basis == "quadratic";
            const Best best = add_over_stiffness({method, 0.01, 0, 45, basis}, stiffnesses, next, table);
            next += stiffnesses.size();
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
    depth_over_step(options, file, report);
    depth_over_stiffness(options, file, report);
}

}  // namespace enduring::chapter03
