#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/10_self_contact/solver.hpp"
#include "chapters/solvers/experiments.hpp"
#include "chapters/solvers/worst_scenes.hpp"
#include "common/experiments/report/statistics.hpp"
#include "common/experiments/run/processor_clock.hpp"
#include "common/experiments/run/run.hpp"
#include "common/scenes/scene_reader.hpp"
#include "common/simulation/deformable_body.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace enduring::solvers {
namespace {

constexpr double frame = 1.0 / 30;  ///< what an eye takes for a motion [s]
constexpr int steps_a_frame = 2;
constexpr double patience = 120;  ///< processor time after which a run is left with what it has [s]

/// A kind of scene with more and more of the same.
struct Series {
    std::string name, word, counted;
    std::vector<int> counts;
    std::function<Scene(int size)> make;
    double seconds;  ///< [s]
};

/// What the steps of a run take from the first one that has a pair.
struct GrowthRun {
    int steps = 0;               ///< with those before
    long counted = 0;            ///< bodies that move, or elements
    double pairs = 0;            ///< mean of a step
    std::vector<double> cpu_ms;  ///< processor time of each step, of all threads
    double wall_s = 0;           ///< of all steps, by the time of day [s]
    std::vector<Vec3> end;       ///< where all vertices are after the last step
};

long count_of(const World& world)
{
    long bodies = 0, elements = 0;
    for (const auto& body : world.bodies) {
        bodies += !body->is_static();
        if (const auto* soft = dynamic_cast<const DeformableBody*>(body.get()))
            elements += static_cast<long>(soft->elastic().mesh().elements().size());
    }
    return elements > 0 ? elements : bodies;
}

/// @param steps  at most so many
GrowthRun run_steps(Scene scene, int threads, int steps)
{
    ImplicitSettings settings;
    settings.threads = threads;
    settings.record = [](const SolveRecord&) {};
    const Solver solver = chapter10_solver(scene.contact, settings);
    Contacts contacts;
    GrowthRun run;
    run.counted = count_of(scene.world);
    const double start = processor_seconds_of_all_threads(), day = seconds_of(CLOCK_MONOTONIC);
    double last = start;
    for (; run.steps < steps && last - start < patience; ++run.steps) {
        advance(scene.world, contacts, solver, scene.dt);
        const double now = processor_seconds_of_all_threads();
        if (!contacts.empty() || !run.cpu_ms.empty()) {
            run.cpu_ms.push_back(1000 * (now - last));
            run.pairs += static_cast<double>(contacts.size());
        }
        last = now;
    }
    run.wall_s = seconds_of(CLOCK_MONOTONIC) - day;
    run.pairs /= static_cast<double>(run.cpu_ms.size());
    for (const auto& body : scene.world.bodies)
        run.end.insert(run.end.end(), body->positions_t0().begin(), body->positions_t0().end());
    return run;
}

double power_between(const GrowthRun& few, const GrowthRun& many)
{
    return growth_power(static_cast<double>(few.counted), mean(few.cpu_ms), static_cast<double>(many.counted),
                        mean(many.cpu_ms));
}

/// How many take a frame's time: between two that were measured, by the power of the time between them.
/// "over" and "below" where all that were measured take less, or more.
std::string carried(const std::vector<GrowthRun>& runs)
{
    const double asked = 1000 * frame / steps_a_frame;
    if (mean(runs.front().cpu_ms) > asked)
        return "below " + std::to_string(runs.front().counted);
    for (std::size_t i = 1; i < runs.size(); ++i) {
        const GrowthRun &few = runs[i - 1], &many = runs[i];
        if (mean(many.cpu_ms) <= asked)
            continue;
        const double power = power_between(few, many), more = std::pow(asked / mean(few.cpu_ms), 1 / power);
        return std::to_string(std::lround(static_cast<double>(few.counted) * more));
    }
    return "over " + std::to_string(runs.back().counted);
}

Scene stacks(int cubes) { return chapter07::scene_of(chapter07::many_stacks(cubes), frame / steps_a_frame); }

/// Cubes that fall on a heap, in layers of a square whose side grows with their number.
Scene heap(int cubes)
{
    const int side = static_cast<int>(std::lround(std::cbrt(4.0 * cubes)));
    return chapter07::scene_of(chapter07::loose_cubes(cubes, side, 1), frame / steps_a_frame);
}

Scene spheres(int count)
{
    Scene scene = poured_spheres(count);
    scene.dt = frame / steps_a_frame;
    return scene;
}

/// A soft cube of so many cells along each side, which falls a tenth of its size on a corner of its base.
Scene soft_cube(int cells)
{
    using nlohmann::json;
    const json body{{"name", "cube"},
                    {"type", "deformable"},
                    {"shape", {{"bar", {{"size", {0.2, 0.2, 0.2}}, {"cells", {cells, cells, cells}}}}}},
                    {"basis", "quadratic"},
                    {"young", 2e5},
                    {"poisson", 0.3},
                    {"density", 1000},
                    {"position", {0, 0.13, 0}},
                    {"rotation", {{"axis", {1, 0, 0.5}}, {"angle_deg", 5}}}};
    const json scene{{"name", "soft cube"},
                     {"dt", frame / steps_a_frame},
                     {"duration", 1},
                     {"contact", {{"friction", {{"model", "mass_splitting"}, {"mu_s", 0.5}, {"mu_d", 0.5}}}}},
                     {"planes", {{{"name", "ground"}}}},
                     {"bodies", {body}}};
    return read_scene(scene.dump(), "", "soft cube", {});
}

std::vector<Series> all_series(bool quick)
{
    if (quick)
        return {{"stacks of five at rest", "stacks", "cubes", {10, 20}, stacks, 0.1},
                {"heap that falls", "heap", "cubes", {8, 16}, heap, 0.8},
                {"poured spheres", "spheres", "spheres", {10, 20}, spheres, 0.2},
                {"soft cube", "soft", "quadratic elements", {2, 3}, soft_cube, 0.2}};
    return {{"stacks of five at rest", "stacks", "cubes", {100, 300, 1000, 3000}, stacks, 1},
            {"heap that falls", "heap", "cubes", {30, 100, 300, 1000, 3000}, heap, 3},
            {"poured spheres", "spheres", "spheres", {30, 100, 300, 1000}, spheres, 1},
            {"soft cube", "soft", "quadratic elements", {3, 5, 8, 13}, soft_cube, 1}};
}

}  // namespace

void sizes(const RunOptions& options, Report& report)
{
    Table steps({"scene", "count", "pairs", "mean_ms", "worst_ms", "steps_by_clock"});
    Table page({"scene", "count", "pairs", "mean [ms]", "worst [ms]"});
    Table carried_page({"scene", "at 30 frames a second", "time grows with the power", "with two threads"});
    long differ = 0;
    for (const Series& series : all_series(options.quick)) {
        std::vector<GrowthRun> runs;
        double faster = 0;
        for (const int size : series.counts) {
            const auto asked = static_cast<int>(std::lround(series.seconds * steps_a_frame / frame));
            runs.push_back(run_steps(series.make(size), 1, asked));
            const GrowthRun& one = runs.back();
            const GrowthRun two = run_steps(series.make(size), 2, one.steps);
            faster = one.wall_s / two.wall_s;
            differ += one.steps == two.steps && one.end != two.end;
            const double mean_ms = mean(one.cpu_ms),
                         worst = *std::max_element(one.cpu_ms.begin(), one.cpu_ms.end());
            steps.add({series.name, one.counted, one.pairs, mean_ms, worst, static_cast<long>(one.steps)});
            page.add(
                {series.name, std::to_string(one.counted) + " " + series.counted, one.pairs, mean_ms, worst});
        }
        const double power = power_between(runs.front(), runs.back());
        carried_page.add({series.name, carried(runs) + " " + series.counted, power, faster});
        report.fact("sizes", series.word + "_exponent_by_clock", power, 2);
        report.fact("sizes", series.word + "_carried_by_clock", carried(runs));
        report.fact("sizes", series.word + "_two_threads_by_clock", faster, 2);
    }
    report.table("sizes", steps);
    report.page_table("sizes", page, 3);
    report.page_table("carried", carried_page, 2);
    report.fact("sizes", "differ", static_cast<double>(differ));
    report.fact("sizes", "patience_s", patience);
}

}  // namespace enduring::solvers
