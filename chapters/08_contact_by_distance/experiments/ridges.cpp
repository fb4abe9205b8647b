#include "chapters/07_implicit_contact/experiments/depth_runs.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/experiments/ridge_scenes.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/experiments/render/moments.hpp"

#include <algorithm>
#include <array>

namespace enduring::chapter08 {
namespace {

/// One scene of a kind, drawn at three moments.
void draw_ridges(Report& report)
{
    constexpr int width = 360, height = 260;
    const std::vector<RidgePlan> plans = ridge_plans();
    std::vector<Moment> shown;
    const auto draw = [&](const std::string& name, const std::vector<double>& times, const Vec3& towards) {
        const auto plan = std::find_if(plans.begin(), plans.end(),
                                       [&](const RidgePlan& each) { return each.name == name; });
        Scene scene = ridge_scene(*plan, 0.01);
        MomentsProbe moments(scene, times, mark_pairs, name + ", ");
        chapter07::watch(scene, times.back() + 2 * scene.dt, chapter08_solver, &moments);
        std::vector<Moment> of_scene = moments.moments();
        frame_together(of_scene, towards, static_cast<double>(width) / height);
        shown.insert(shown.end(), of_scene.begin(), of_scene.end());
    };
    draw("ridge on ridge, 1°, 1 mm beside", {0.05, 0.7, 0.85}, {0.8, 0.5, 1});
    draw("box over a border, 1 cm beyond it", {0.05, 0.35, 0.5}, {0.8, 0.5, 1});
    write_png(draw_moments(shown, 3, width, height), report.file("ridges.png"));
}

}  // namespace

/// Ridges, corners and borders on each other, from a centimetre above.
void ridges(const RunOptions& options, Report& report)
{
    constexpr double duration = 1.5;
    Table table({"what falls", "deepest with 10 ms [µm]", "at the end [µm]", "stays with 10 ms",
                 "deepest with 2 ms [µm]", "stays with 2 ms", "unsolved"});
    chapter07::DepthOutcome all;
    for (const RidgePlan& plan : ridge_plans()) {
        std::array<chapter07::DepthOutcome, 2> outcomes;
        std::array<std::string, 2> stays;
        for (const std::size_t i : {0U, 1U}) {
            Scene scene = ridge_scene(plan, i == 0 ? 0.01 : 0.002);
            outcomes[i] = chapter07::measure_depths(scene, duration, chapter08_solver);
            stays[i] = is_held(scene) ? "yes" : "no";
            all.add(outcomes[i]);
        }
        table.add({plan.name, 1e6 * outcomes[0].deepest_m, 1e6 * outcomes[0].at_end_m, stays[0],
                   1e6 * outcomes[1].deepest_m, stays[1], outcomes[0].unsolved + outcomes[1].unsolved});
    }
    report.table("ridges", table);
    report.page_table("ridges", table, 2);
    report.fact("ridges", "scenes", static_cast<double>(table.rows().size()));
    report.fact("ridges", "deepest_um", 1e6 * all.deepest_m, 2);
    report.fact("ridges", "at_the_end_um", 1e6 * all.at_end_m, 2);
    report.fact("ridges", "unsolved", static_cast<double>(all.unsolved));
    if (options.pictures)
        draw_ridges(report);
}

}  // namespace enduring::chapter08
