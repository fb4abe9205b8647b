#include "chapters/07_implicit_contact/experiments/experiments.hpp"
#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "common/experiments/render/film_probes.hpp"

#include <algorithm>

namespace enduring::chapter07 {
/// Cubes dropped on a heap, over seeds and steps.
void heap(const RunOptions& options, Report& report)
{
    Table table({"cubes", "dt_s", "seed", "deepest_mm", "deepest_ever_mm", "drift_um_per_s", "energy_gain_j",
                 "most_newton_steps", "newton_steps_at_rest", "unconverged", "solves"});
    const int n = options.quick ? 16 : 30, side = options.quick ? 2 : 3;
    double deepest = 0, drift = 0, gain = 0;
    long unconverged = 0, solves = 0;
    for (const double dt : {0.01, 1.0 / 60})
        for (const unsigned seed : {1u, 2u, 3u}) {
            if (options.quick && seed > 1)
                continue;
            Scene scene = scene_of(loose_cubes(n, side, seed), dt);
            scene.camera = {Vec3(9, 6, 14), Vec3(0, 2.5, 0), 40};
            const double duration = 6;
            StripProbe strip(
                scene, {0, 1, duration - dt}, [](auto&&...) {}, 480, 360);
            const PileOutcome outcome = watch(scene, duration, &strip);
            if (table.rows().empty())
                write_png(strip.all(3), report.file("heap.png"));
            table.add({static_cast<long>(n), dt, static_cast<long>(seed), outcome.deepest_mm,
                       outcome.deepest_ever_mm, outcome.drift_um_per_s, outcome.energy_gain_j,
                       static_cast<long>(outcome.solves.most_newton_steps), outcome.newton_steps_at_rest,
                       outcome.solves.unconverged, outcome.solves.solves});
            deepest = std::max(deepest, outcome.deepest_mm);
            drift = std::max(drift, outcome.drift_um_per_s);
            gain = std::max(gain, outcome.energy_gain_j);
            unconverged += outcome.solves.unconverged;
            solves += outcome.solves.solves;
        }
    report.table("heap", table);
    report.page_table("heap", table, 2);
    report.fact("heap", "cubes", n);
    report.fact("heap", "deepest_mm", deepest, 2);
    report.fact("heap", "drift_um_per_s", drift, 2);
    report.fact("heap", "energy_gain_j", gain, 2);
    report.fact("heap", "unconverged", static_cast<double>(unconverged));
    report.fact("heap", "solves", static_cast<double>(solves));
}

}  // namespace enduring::chapter07
