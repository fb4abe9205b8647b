#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/experiments/true_depth.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/experiments/render/moments.hpp"
#include "common/experiments/report/growing_table.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::chapter08 {
namespace {

struct Drop {
    int cubes, side;
    double dt;
    unsigned seed;
    double duration;  ///< [s]; some cubes stand on an edge for long before they tip over
};

std::vector<Drop> all_drops(bool quick)
{
    if (quick)
        return {{16, 2, 0.01, 1, 12}, {16, 2, 1.0 / 60, 1, 12}};
    return {{100, 4, 1.0 / 60, 1, 24},
            {30, 3, 0.01, 2, 24},
            {30, 3, 1.0 / 60, 3, 24},
            {40, 3, 0.02, 12, 24},
            {40, 3, 0.02, 25, 24}};
}

/// A camera that sees the cubes as they hang, and the ground that they will spread over.
SceneCamera camera_of(const Scene& scene, int cubes, const Vec3& seen_from, double aspect)
{
    std::vector<Vec3> points = points_of(stage_of(scene.world, scene));
    const double spread = 0.6 * std::sqrt(cubes);  // [m] to each side
    for (const double x : {-spread, spread})
        for (const double z : {-spread, spread})
            points.emplace_back(x, 0, z);
    const Camera camera = frame(points, seen_from, aspect, 0.04);
    return {camera.eye, camera.target, camera.field_of_view_deg};
}

struct HeapOutcome {
    chapter07::PileOutcome pile;
    double deepest_ever_mm = 0;  ///< after any step, whatever the pairs say
};

HeapOutcome run_heap(Scene& scene, double duration, Probe* observer = nullptr)
{
    HeapOutcome outcome;
    WatchProbe all([&](const World& world, const Contacts& contacts, double dt) {
        outcome.deepest_ever_mm = std::max(outcome.deepest_ever_mm, 1e3 * chapter07::true_depth(world));
        if (observer)
            observer->observe(world, contacts, dt);
    });
    outcome.pile = chapter07::watch(scene, duration, chapter08_solver, &all);
    return outcome;
}

/// Three moments, each as near as may be, and the first seconds as a film.
HeapOutcome run_and_show(Scene& scene, const Drop& drop, bool quick, Report& report)
{
    constexpr int width = 480, height = 400;
    const Vec3 seen_from(0.6, 0.4, 1);
    scene.camera = camera_of(scene, drop.cubes, seen_from, static_cast<double>(width) / height);
    MomentsProbe pictures(scene, {0, 1, drop.duration - drop.dt}, mark_pairs);
    ClipProbe film(scene, report.file("heap.webp"), quick ? 4 : 20, width, height, {.until = 6});
    WatchProbe both([&](const World& world, const Contacts& contacts, double dt) {
        pictures.observe(world, contacts, dt);
        film.observe(world, contacts, dt);
    });
    const HeapOutcome outcome = run_heap(scene, drop.duration, &both);
    film.finish();
    std::vector<Moment> moments = pictures.moments();
    frame_each(moments, seen_from, static_cast<double>(width) / height);
    write_png(draw_moments(moments, 3, width, height), report.file("heap.png"));
    return outcome;
}

}  // namespace

/// Cubes dropped on a heap, over seeds and steps.
void heap(const RunOptions& options, Report& report)
{
    GrowingTable table(report, "heap",
                       {"cubes", "dt_s", "seed", "pairs", "deepest_mm", "deepest_ever_mm", "drift_um_per_s",
                        "energy_gain_j", "max_newton_steps", "newton_steps_at_rest", "unconverged", "solves"},
                       all_drops(options.quick).size());
    double deepest = 0, ever = 0, drift = 0, gain = 0;
    long unconverged = 0, solves = 0, pairs = 0;
    for (const Drop& drop : all_drops(options.quick)) {
        Scene scene = chapter07::scene_of(chapter07::loose_cubes(drop.cubes, drop.side, drop.seed), drop.dt);
        const auto [outcome, deepest_ever_mm] = table.rows().empty()
                                                    ? run_and_show(scene, drop, options.quick, report)
                                                    : run_heap(scene, drop.duration);
        table.add({static_cast<long>(drop.cubes), drop.dt, static_cast<long>(drop.seed), outcome.pairs,
                   outcome.deepest_mm, deepest_ever_mm, outcome.drift_um_per_s, outcome.energy_gain_j,
                   static_cast<long>(outcome.solves.max_newton_steps), outcome.newton_steps_at_rest,
                   outcome.solves.unconverged, outcome.solves.solves});
        if (table.rows().size() == 1)
            pairs = outcome.pairs;
        deepest = std::max(deepest, outcome.deepest_mm);
        ever = std::max(ever, deepest_ever_mm);
        drift = std::max(drift, outcome.drift_um_per_s);
        gain = std::max(gain, outcome.energy_gain_j);
        unconverged += outcome.solves.unconverged;
        solves += outcome.solves.solves;
    }
    report.table("heap", table);
    report.page_table("heap", table, 2);
    report.fact("heap", "cubes", all_drops(options.quick).front().cubes);
    report.fact("heap", "pairs", static_cast<double>(pairs));
    report.fact("heap", "deepest_mm", deepest, 2);
    report.fact("heap", "deepest_ever_mm", ever, 2);
    report.fact("heap", "drift_um_per_s", drift, 2);
    report.fact("heap", "energy_gain_j", gain, 2);
    report.fact("heap", "unconverged", static_cast<double>(unconverged));
    report.fact("heap", "solves", static_cast<double>(solves));
}

}  // namespace enduring::chapter08
