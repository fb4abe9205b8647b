#include "chapters/07_implicit_contact/experiments/experiments.hpp"
#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "common/experiments/render/film_probes.hpp"
#include "common/experiments/report/growing_table.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::chapter07 {
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

}  // namespace

/// Cubes dropped on a heap, over seeds and steps.
void heap(const RunOptions& options, Report& report)
{
    GrowingTable table(
        report, "heap",
        {"cubes", "dt_s", "seed", "deepest_mm", "deepest_ever_mm", "drift_um_per_s", "energy_gain_j",
         "most_newton_steps", "newton_steps_at_rest", "unconverged", "solves"},
        all_drops(options.quick).size());
    double deepest = 0, ever = 0, drift = 0, gain = 0;
    long unconverged = 0, solves = 0;
    for (const Drop& drop : all_drops(options.quick)) {
        Scene scene = scene_of(loose_cubes(drop.cubes, drop.side, drop.seed), drop.dt);
        scene.camera = {Vec3(4.5, 3, 7) * std::sqrt(drop.cubes / 4.0), Vec3(0, 2.5, 0), 40};
        StripProbe strip(
            scene, {0, 1, drop.duration - drop.dt}, [](auto&&...) {}, 480, 360);
        const bool drawn = table.rows().empty();
        const PileOutcome outcome = watch(scene, drop.duration, drawn ? &strip : nullptr);
        if (drawn)
            write_png(strip.all(3), report.file("heap.png"));
        table.add({static_cast<long>(drop.cubes), drop.dt, static_cast<long>(drop.seed), outcome.deepest_mm,
                   outcome.deepest_ever_mm, outcome.drift_um_per_s, outcome.energy_gain_j,
                   static_cast<long>(outcome.solves.most_newton_steps), outcome.newton_steps_at_rest,
                   outcome.solves.unconverged, outcome.solves.solves});
        deepest = std::max(deepest, outcome.deepest_mm);
        ever = std::max(ever, outcome.deepest_ever_mm);
        drift = std::max(drift, outcome.drift_um_per_s);
        gain = std::max(gain, outcome.energy_gain_j);
        unconverged += outcome.solves.unconverged;
        solves += outcome.solves.solves;
    }
    report.table("heap", table);
    report.page_table("heap", table, 2);
    report.fact("heap", "cubes", all_drops(options.quick).front().cubes);
    report.fact("heap", "deepest_mm", deepest, 2);
    report.fact("heap", "deepest_ever_mm", ever, 2);
    report.fact("heap", "drift_um_per_s", drift, 2);
    report.fact("heap", "energy_gain_j", gain, 2);
    report.fact("heap", "unconverged", static_cast<double>(unconverged));
    report.fact("heap", "solves", static_cast<double>(solves));
}

}  // namespace enduring::chapter07
