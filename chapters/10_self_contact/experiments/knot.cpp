#include "chapters/10_self_contact/experiments/bent_bars.hpp"
#include "chapters/10_self_contact/experiments/experiments.hpp"
#include "chapters/10_self_contact/experiments/soft_runs.hpp"
#include "common/experiments/render/film_probes.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace enduring::chapter10 {
namespace {

constexpr double pulled = 1.5, eased = 1.5;  ///< so long [s] the ends are pulled hard, and then less
constexpr double kept = 0.4;                 ///< of the pull

/// A loose overhand knot, weightless, whose ends are pulled apart.
SoftRun pulled_knot(double mu, double force)
{
    const SoftVariant variant{.young = 1e5, .cells = 5, .dt = 0.005, .mu = mu};
    constexpr double thickness = 0.01;
    SoftRun run = soft_run(variant);
    run.scene.world.gravity.setZero();
    add_soft(run.scene, "rope", overhand_knot(0.045, 0.06, thickness, 48), variant);
    const auto places = run.scene.world.bodies[0]->positions_t0();
    const auto [left, right] = std::minmax_element(
        places.begin(), places.end(), [](const Vec3& a, const Vec3& b) { return a.x() < b.x(); });
    for (const double side : {-1, 1}) {
        Pull pull{.force = {side * kept * force, 0, 0}, .until = pulled + eased};
        for (std::size_t vertex = 0; vertex < places.size(); ++vertex)
            if (side * (places[vertex].x() - (side < 0 ? left : right)->x()) > -thickness / 10)
                pull.vertices.push_back(static_cast<int>(vertex));
        run.pulls.push_back(pull);
    }
    for (const int end : {0, 1}) {
        Pull harder = run.pulls[end];
        harder.force *= 1 / kept - 1;
        harder.until = pulled;
        run.pulls.push_back(harder);
    }
    run.scene.camera = {{0, 0.2, 0.75}, {0, -0.01, 0}, 17};
    run.scene.looks["rope"] = {palette::terracotta, false};
    return run;
}

/// From end to end [m].
double span_of(const SoftRun& run, const World& world)
{
    const auto middle = [&](const Pull& pull) {
        Vec3 sum = Vec3::Zero();
        for (const int vertex : pull.vertices)
            sum += world.bodies[0]->positions_t0()[vertex];
        return Vec3(sum / static_cast<double>(pull.vertices.size()));
    };
    return (middle(run.pulls[1]) - middle(run.pulls[0])).norm();
}

}  // namespace

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
                now = span_of(run, world);
                if (world.step == 0)
                    first = now;
                if (world.time <= pulled)
                    tight = now;
            });
            StripProbe film(
                run.scene, {0, 0.1, pulled, pulled + eased}, [](auto&&...) {}, 480, 210);
            std::vector<Probe*> probes{&watch, &film};
            std::optional<ClipProbe> clip;
            if (force < 0.7 && mu < 0.1)  // three seconds of the slippery one are ten of the clip
                probes.push_back(&clip.emplace(run.scene, report.file("knot.webp"), options.quick ? 4 : 20,
                                               640, 280, FilmStyle{.slow_motion = 10.0 / 3}));
            const double duration = options.quick ? 0.1 : pulled + eased;
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
