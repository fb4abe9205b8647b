#include "chapters/07_implicit_contact/experiments/depth_runs.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/experiments/shapes.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/experiments/render/renderer.hpp"
#include "common/experiments/render/scene_view.hpp"
#include "common/experiments/render/strip.hpp"
#include "common/experiments/report/sweep.hpp"

#include <array>

namespace enduring::chapter08 {
namespace {

/// So many heaps of each family, and so many of them with the solver of the chapter before, too.
struct FamilySeeds {
    unsigned count, with_both;
};
constexpr FamilySeeds full_seeds{200, 10}, quick_seeds_of_families{1, 1};

/// The heap of a seed: the step, the friction and the spin take turns with periods that have no common
/// factor, so a hundred and ten seeds have each with each.
HeapPlan plan_of(int family, unsigned seed, bool quick)
{
    if (quick)
        return {family, 8, 0.01, 0.3, seed};
    constexpr std::array steps{0.001, 0.002, 0.005, 0.01, 0.02};
    const double dt = steps.at(seed % 5), mu = 0.1 * (seed * 7 % 11), spin = seed % 2 == 0 ? 30 : 0;
    const int bodies = seed % 100 == 13 ? 100 : seed % 20 == 8 ? 30 : 8;
    return {family, bodies, dt, mu, seed, spin};
}

void draw_heaps(bool quick, Report& report)
{
    constexpr int width = 300, height = 230;
    std::vector<StripPicture> pictures;
    for (int family = 0; family < mixed_family; ++family) {
        Scene scene = random_heap({family, quick ? 5 : 16, 0.01, 1, 1});
        chapter07::watch(scene, quick ? 1 : 4, chapter08_solver);
        Stage stage = stage_of(scene.world, scene);
        stage.camera = frame(points_of(stage), {0.6, 0.6, 1}, static_cast<double>(width) / height);
        pictures.push_back({Renderer(width, height).draw(stage), family_name(family)});
    }
    write_png(strip(pictures, 4), report.file("families.png"));
}

double percent_of(double depth, const chapter07::DepthOutcome& outcome)
{
    return 100 * depth / outcome.size_m;
}

using chapter07::DepthOutcome;

/// What all heaps of a family came to, which of them has the deepest body, and how many have one that is
/// deeper than half a percent of the smallest body's size.
struct FamilyOutcome {
    DepthOutcome worst;
    long runs = 0, deep = 0;
    unsigned deepest_seed = 0;

    void add(const DepthOutcome& run, unsigned seed)
    {
        if (run.deepest_m > worst.deepest_m)
            deepest_seed = seed;
        worst.add(run);
        deep += run.deepest_m > 5e-3 * run.size_m;
        ++runs;
    }
};

/// @param found  of the first seed all families, then of the next seed all families
std::array<FamilyOutcome, family_count> by_family(const std::vector<DepthOutcome>& found, unsigned seeds)
{
    std::array<FamilyOutcome, family_count> families;
    for (std::size_t i = 0; i < seeds * families.size(); ++i)
        families.at(i % families.size()).add(found.at(i), 1 + static_cast<unsigned>(i / families.size()));
    return families;
}

void report_families(const std::vector<DepthOutcome>& found, const FamilySeeds& seeds, bool quick,
                     Report& report)
{
    Table table({"family", "bodies", "runs", "deepest_percent", "of_seed", "deep_heaps", "at_the_end_percent",
                 "gain_percent", "lost", "unsolved", "solves", "max_newton_steps"});
    const auto families = by_family(found, seeds.count);
    DepthOutcome all;
    double deepest = 0, at_end = 0;
    long all_deep = 0;
    for (int family = 0; family < family_count; ++family) {
        const auto& [worst, runs, deep, seed] = families.at(static_cast<std::size_t>(family));
        table.add({family_name(family), std::string(quick ? "8" : "8 to 100"), runs,
                   percent_of(worst.deepest_m, worst), static_cast<long>(seed), deep,
                   percent_of(worst.at_end_m, worst), 100 * worst.gain, static_cast<long>(worst.lost),
                   worst.unsolved, worst.solves, static_cast<long>(worst.max_newton_steps)});
        deepest = std::max(deepest, percent_of(worst.deepest_m, worst));
        at_end = std::max(at_end, percent_of(worst.at_end_m, worst));
        all.add(worst);
        all_deep += deep;
    }
    report.table("families", table);
    report.page_table("families", table, 2);
    const auto tell = [&](const std::string& name, double value, int digits) {
        report.fact("families", name, value, digits);
    };
    tell("runs", static_cast<double>(found.size()), 4);
    tell("deepest_percent", deepest, 2);
    tell("at_the_end_percent", at_end, 2);
    tell("deep", static_cast<double>(all_deep), 6);
    tell("deepest_mm", 1e3 * all.deepest_m, 2);
    tell("at_the_end_um", 1e6 * all.at_end_m, 2);
    tell("gain_percent", 100 * all.gain, 2);
    tell("lost", all.lost, 6);
    tell("unsolved", static_cast<double>(all.unsolved), 6);
    tell("solves", static_cast<double>(all.solves), 6);
    tell("max_newton_steps", all.max_newton_steps, 6);
}

/// The first heaps with chapter 7's solver, and with this one.
void report_before(const std::vector<DepthOutcome>& with_7, const std::vector<DepthOutcome>& with_8,
                   const FamilySeeds& seeds, Report& report)
{
    Table table({"family", "runs", "deepest_with_7_mm", "deepest_with_8_mm", "at_the_end_with_7_um",
                 "at_the_end_with_8_um", "lost_with_7", "lost_with_8", "unsolved_with_7", "unsolved_with_8"});
    const auto families_7 = by_family(with_7, seeds.with_both),
               families_8 = by_family(with_8, seeds.with_both);
    DepthOutcome all;
    for (int family = 0; family < family_count; ++family) {
        const auto i = static_cast<std::size_t>(family);
        const DepthOutcome &seven = families_7.at(i).worst, &eight = families_8.at(i).worst;
        table.add({family_name(family), families_7.at(i).runs, 1e3 * seven.deepest_m, 1e3 * eight.deepest_m,
                   1e6 * seven.at_end_m, 1e6 * eight.at_end_m, static_cast<long>(seven.lost),
                   static_cast<long>(eight.lost), seven.unsolved, eight.unsolved});
        all.add(seven);
    }
    report.table("families_before", table);
    report.page_table("families_before", table, 2);
    report.fact("families", "deepest_before_mm", 1e3 * all.deepest_m, 2);
    report.fact("families", "at_the_end_before_um", 1e6 * all.at_end_m, 2);
}

}  // namespace

/// Heaps at random of eight families of shapes: how deep bodies come into each other.
void families(const RunOptions& options, Report& report)
{
    const FamilySeeds seeds = options.quick ? quick_seeds_of_families : full_seeds;
    const double duration = options.quick ? 1.2 : 2;
    const auto run_with = [&](chapter07::MakeSolver make) {
        return [make, duration, quick = options.quick](std::size_t i) {
            Scene scene = random_heap(plan_of(static_cast<int>(i % family_count),
                                              1 + static_cast<unsigned>(i / family_count), quick));
            return chapter07::measure_depths(scene, duration, make);
        };
    };
    const auto found = sweep<DepthOutcome>(options, "families", family_count * seeds.count,
                                           run_with(chapter08_solver));
    const auto before = sweep<DepthOutcome>(options, "families_before", family_count * seeds.with_both,
                                            run_with(chapter07_solver));
    if (!found || !before)
        return;
    report_families(*found, seeds, options.quick, report);
    report_before(*before, *found, seeds, report);
    draw_heaps(options.quick, report);
}

}  // namespace enduring::chapter08
