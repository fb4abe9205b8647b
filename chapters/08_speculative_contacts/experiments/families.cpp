#include "chapters/07_implicit_contact/experiments/depth_runs.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "chapters/08_speculative_contacts/experiments/experiments.hpp"
#include "chapters/08_speculative_contacts/experiments/shapes.hpp"
#include "chapters/08_speculative_contacts/solver.hpp"
#include "common/experiments/render/renderer.hpp"
#include "common/experiments/render/scene_view.hpp"
#include "common/experiments/render/strip.hpp"
#include "common/experiments/report/sweep.hpp"

#include <array>

namespace enduring::chapter08 {
namespace {

/// The heaps of one family.
std::vector<HeapPlan> heaps_of(int family, bool quick)
{
    if (quick)
        return {{family, 8, 0.01, 0.3, 1}};
    std::vector<HeapPlan> plans;
    struct Way {
        double dt, mu;
    };
    for (const auto& [dt, mu] : {Way{0.001, 0.3}, {0.005, 1}, {0.01, 0}, {0.01, 0.3}, {0.02, 0}, {0.02, 1}})
        for (unsigned seed = 1; seed <= 4; ++seed)
            plans.push_back({family, 8, dt, mu, seed});
    for (unsigned seed = 1; seed <= 2; ++seed)
        plans.push_back({family, 30, 0.01, 0.5, seed});
    plans.push_back({family, 100, 0.01, 0.5, 1});
    return plans;
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

void report_families(const std::vector<chapter07::DepthOutcome>& found, std::size_t runs, bool quick,
                     Report& report)
{
    Table now({"family", "bodies", "runs", "deepest_percent", "at_the_end_percent", "gain_percent",
               "unsolved", "solves", "max_newton_steps"});
    Table before({"family", "runs", "deepest_with_7_mm", "deepest_with_8_mm", "at_the_end_with_7_um",
                  "at_the_end_with_8_um", "unsolved_with_7", "unsolved_with_8"});
    std::array<chapter07::DepthOutcome, 2> all;  // chapter 7's, chapter 8's
    double deepest = 0, at_end = 0;
    for (int family = 0; family < family_count; ++family) {
        std::array<chapter07::DepthOutcome, 2> worst;
        for (std::size_t i = 0; i < runs; ++i)
            for (const std::size_t way : {0U, 1U})
                worst[way].add(found[2 * (static_cast<std::size_t>(family) * runs + i) + way]);
        const auto& [seven, eight] = worst;
        now.add({family_name(family), std::string(quick ? "8" : "8 to 100"), static_cast<long>(runs),
                 percent_of(eight.deepest_m, eight), percent_of(eight.at_end_m, eight), 100 * eight.gain,
                 eight.unsolved, eight.solves, static_cast<long>(eight.max_newton_steps)});
        before.add({family_name(family), static_cast<long>(runs), 1e3 * seven.deepest_m,
                    1e3 * eight.deepest_m, 1e6 * seven.at_end_m, 1e6 * eight.at_end_m, seven.unsolved,
                    eight.unsolved});
        deepest = std::max(deepest, percent_of(eight.deepest_m, eight));
        at_end = std::max(at_end, percent_of(eight.at_end_m, eight));
        all[0].add(seven);
        all[1].add(eight);
    }
    report.table("families", now);
    report.page_table("families", now, 2);
    report.table("families_before", before);
    report.page_table("families_before", before, 2);
    report.fact("families", "runs", static_cast<double>(runs * family_count), 4);
    report.fact("families", "deepest_percent", deepest, 2);
    report.fact("families", "at_the_end_percent", at_end, 2);
    report.fact("families", "deepest_mm", 1e3 * all[1].deepest_m, 2);
    report.fact("families", "at_the_end_um", 1e6 * all[1].at_end_m, 2);
    report.fact("families", "deepest_before_mm", 1e3 * all[0].deepest_m, 2);
    report.fact("families", "at_the_end_before_um", 1e6 * all[0].at_end_m, 2);
    report.fact("families", "gain_percent", 100 * all[1].gain, 2);
    report.fact("families", "unsolved", static_cast<double>(all[1].unsolved), 6);
    report.fact("families", "solves", static_cast<double>(all[1].solves), 6);
    report.fact("families", "max_newton_steps", all[1].max_newton_steps);
}

}  // namespace

/// Heaps at random of eight families of shapes: how deep bodies come into each other.
void families(const RunOptions& options, Report& report)
{
    std::vector<HeapPlan> plans;
    for (int family = 0; family < family_count; ++family)
        for (const HeapPlan& plan : heaps_of(family, options.quick))
            plans.push_back(plan);
    const double duration = options.quick ? 1.2 : 3;
    constexpr std::array<chapter07::MakeSolver, 2> solvers{chapter07_solver, chapter08_solver};
    const auto found = sweep<chapter07::DepthOutcome>(
        options, "families", 2 * plans.size(), [&](std::size_t i) {
            Scene scene = random_heap(plans[i / 2]);
            return chapter07::measure_depths(scene, duration, solvers[i % 2]);
        });
    if (!found)
        return;
    report_families(*found, plans.size() / family_count, options.quick, report);
    draw_heaps(options.quick, report);
}

}  // namespace enduring::chapter08
