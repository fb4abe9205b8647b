#include "chapters/10_self_contact/experiments/experiments.hpp"
#include "chapters/10_self_contact/experiments/pulled_knot.hpp"
#include "common/experiments/render/film_probes.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace enduring::chapter10 {

/// An overhand knot is pulled tight and then less: what friction changes.
void knot(const RunOptions& options, Report& report)
{
    Table table({"friction", "pull_n", "travel_mm", "back_mm", "own_pairs", "crossings", "deepest_um",
                 "inverted", "unconverged"});
    std::vector<StripPicture> rows;
    std::array<std::array<double, 2>, 2> travel{};  // [mm] by pull and by friction
    double deepest = 0;                             // [m]
    for (const double force : {0.5, 1.0})
        for (const double mu : {0.02, 0.5}) {
            SoftRun run = pulled_knot(mu, force);
            double first = 0, tight = 0, now = 0;
            WatchProbe watch([&](const World& world, const Contacts&, double) {
                now = knot_span(run, world);
                if (world.step == 0)
                    first = now;
                if (world.time <= knot_pulled)
                    tight = now;
            });
            StripProbe film(
                run.scene, {0, 0.1, knot_pulled, knot_pulled + knot_eased}, [](auto&&...) {}, 480, 210);
            std::vector<Probe*> probes{&watch, &film};
            std::optional<ClipProbe> clip;
            if (force < 0.7 && mu < 0.1)  // three seconds of the slippery one are ten of the clip
                probes.push_back(&clip.emplace(run.scene, report.file("knot.webp"), options.quick ? 4 : 20,
                                               640, 280, FilmStyle{.slow_motion = 10.0 / 3}));
            const double duration = options.quick ? 0.1 : knot_pulled + knot_eased;
            const Folded f = fold(run, static_cast<int>(duration / run.scene.dt + 0.5), probes);
            if (clip)
                clip->finish();
            travel[force > 0.7][mu > 0.1] = 1000 * (tight - first);
            deepest = std::max(deepest, f.depth);
            table.add({mu, force, 1000 * (tight - first), 1000 * (tight - now), f.pairs, f.crossings,
                       1e6 * f.depth, f.inverted, f.unconverged});
            if (force < 0.7)
                rows.push_back({film.all(4), mu > 0.1 ? "friction 0.5" : "friction 0.02"});
        }
    write_png(strip(rows, 1), report.file("knot.png"));
    report.table("knot", table);
    report.page_table("knot", table, 3);
    report.fact("knot", "slippery_mm", travel[1][0]);
    report.fact("knot", "rough_mm", travel[1][1]);
    report.fact("knot", "deepest_um", 1e6 * deepest, 2);
}

}  // namespace enduring::chapter10
