#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/experiments/rest_scenes.hpp"
#include "chapters/07_implicit_contact/experiments/soft_scenes.hpp"
#include "chapters/10_self_contact/solver.hpp"
#include "chapters/11_exact_contact/experiments/experiments.hpp"
#include "chapters/11_exact_contact/solver.hpp"
#include "common/experiments/report/growing_table.hpp"
#include "common/experiments/run/processor_clock.hpp"

#include <algorithm>
#include <functional>
#include <string>

namespace enduring::chapter11 {
namespace {

/// A scene, and how long it is watched.
struct Row {
    std::string name;
    std::function<Scene()> make;
    double duration;  ///< [s]
    bool in_quick = true;
};

std::vector<Row> all_rows(bool quick)
{
    using namespace chapter07;
    constexpr double dt = 0.01;
    const double rest = quick ? 2 : 8;
    return {
        {"10 cubes", [] { return scene_of(stack_of(10), dt); }, rest},
        {"1,000 kg on 10 kg", [] { return scene_of(stack_of(2, 10, 1000), dt); }, rest},
        {"20,000 : 1", [] { return scene_of(stack_of(2, 10, 200000), dt); }, rest},
        {"cube on a slope of 20 degrees",
         [] {
             return scene_of({{10, Vec3(0, 0.5, 0), 0}}, dt, 20);
         },
         rest},
        {"cube that slides down 30 degrees",
         [] {
             return scene_of({{10, Vec3(0, 0.5, 0), 0}}, dt, 30);
         },
         2},
        {"soft cube on a slope of 10 degrees",
         [] {
             return soft_cube_on_triangles({2, 1e6, dt, 10}, 0.3);
         },
         quick ? 4.0 : 8.0},
        {"card house of 3 levels", [] { return scene_of(card_house(3, 15), dt); }, rest},
        {"arch of 20 stones", [] { return arch(20, 5, dt); }, rest},
        {"wedge in a crack", [] { return tip_in_crack(Tip::wedge, 33, 60, dt); }, quick ? 2.0 : 8.0, false},
        {quick ? "heap of 8" : "heap of 27",
         [quick] { return scene_of(loose_cubes(quick ? 8 : 27, quick ? 2 : 3, 2), dt); }, quick ? 4.0 : 16.0},
    };
}

struct Watched {
    chapter07::PileOutcome pile;
    double seconds = 0;
};

Watched watch(const Row& row, chapter07::MakeSolver make)
{
    Scene scene = row.make();
    const double start = processor_seconds();
    Watched watched{chapter07::watch(scene, row.duration, make)};
    watched.seconds = processor_seconds() - start;
    return watched;
}

/// How passes went in all runs: those of a step, and steps that took all that there were.
struct Passes {
    long responses = 0, passes = 0, not_reached = 0;

    void add(const PassRecord& record)
    {
        ++responses;
        passes += record.passes;
        not_reached += !record.reached;
    }
};
Passes counted;  // a MakeSolver is a plain function

Solver counted_solver(const ContactParameters& parameters, ImplicitSettings settings)
{
    settings.threads = 1;  // the clock is this thread's
    return chapter11_solver(parameters, std::move(settings),
                            {.record = [](const PassRecord& record) { counted.add(record); }});
}

Solver before_solver(const ContactParameters& parameters, ImplicitSettings settings)
{
    settings.threads = 1;
    return chapter10_solver(parameters, std::move(settings));
}

}  // namespace

/// Scenes at rest under chapter 10's springs and under springs that remember: depth, drift, passes, time.
void exact_scenes(const RunOptions& options, Report& report)
{
    const std::vector<Row> rows = all_rows(options.quick);
    GrowingTable table(report, "exact_scenes",
                       {"scene", "springs_depth_um", "exact_depth_um", "springs_drift_um_per_s",
                        "exact_drift_um_per_s", "passes_per_solve", "not_reached", "time_ratio"},
                       rows.size());
    double deepest = 0, fastest = 0;
    for (const Row& row : rows) {
        if (options.quick && !row.in_quick)
            continue;
        const Watched springs = watch(row, before_solver);
        counted = {};
        const Watched exact = watch(row, counted_solver);
        table.add({row.name, 1e3 * springs.pile.deepest_mm, 1e3 * exact.pile.deepest_mm,
                   springs.pile.drift_um_per_s, exact.pile.drift_um_per_s,
                   static_cast<double>(counted.passes) / static_cast<double>(std::max(1L, counted.responses)),
                   counted.not_reached, exact.seconds / springs.seconds});
        deepest = std::max(deepest, 1e3 * exact.pile.deepest_mm);
        if (row.name.find("slides") == std::string::npos)
            fastest = std::max(fastest, exact.pile.drift_um_per_s);
    }
    report.table("exact_scenes", table);
    report.page_table("exact_scenes", table, 2);
    report.fact("exact_scenes", "deepest_um", deepest, 2);
    report.fact("exact_scenes", "fastest_um_per_s", fastest, 2);
}

}  // namespace enduring::chapter11
