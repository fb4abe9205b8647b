#include "chapters/07_implicit_contact/experiments/experiments.hpp"
#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "common/experiments/render/film_probes.hpp"
#include "common/experiments/report/growing_table.hpp"

#include <algorithm>

namespace enduring::chapter07 {
namespace {

struct Case {
    std::string name;
    std::vector<Box> boxes;
    double dt;
};

std::vector<Case> all_cases()
{
    std::vector<Case> cases;
    for (const double dt : {0.01, 1.0 / 60}) {
        for (const int n : {10, 20})
            cases.push_back({std::to_string(n) + " cubes", stack_of(n), dt});
        cases.push_back({"10 cubes, corner on corner", stack_of(10, 10, 10, 0), dt});
        cases.push_back({"1000 kg on 1 kg", stack_of(2, 1, 1000), dt});
        cases.push_back({"1 kg on 1000 kg", stack_of(2, 1000, 1), dt});
    }
    return cases;
}

}  // namespace

/// Stacks of cubes, equal ones and 1000 : 1, for 20 s: no number is chosen for any of them.
void stack(const RunOptions& options, Report& report)
{
    GrowingTable table(report, "stack",
                       {"stack", "dt_s", "deepest_mm", "drift_um_per_s", "energy_gain_j", "most_newton_steps",
                        "newton_steps_at_rest", "unconverged", "solves"},
                       all_cases().size());
    double deepest = 0, drift = 0;
    for (const Case& c : all_cases()) {
        Scene scene = scene_of(c.boxes, c.dt);
        const double duration = options.quick ? 2 : 20;
        scene.camera = {Vec3(9, 9, 24), Vec3(0, 9, 0), 50};
        StripProbe strip(
            scene, {0, duration - c.dt}, [](auto&&...) {}, 320, 480);
        const bool drawn = c.boxes.size() == 20 && c.dt == 0.01;
        const PileOutcome outcome = watch(scene, duration, drawn ? &strip : nullptr);
        if (drawn)
            write_png(strip.all(2), report.file("stack.png"));
        table.add({c.name, c.dt, outcome.deepest_mm, outcome.drift_um_per_s, outcome.energy_gain_j,
                   static_cast<long>(outcome.solves.most_newton_steps), outcome.newton_steps_at_rest,
                   outcome.solves.unconverged, outcome.solves.solves});
        deepest = std::max(deepest, outcome.deepest_mm);
        drift = std::max(drift, outcome.drift_um_per_s);
    }
    report.table("stack", table);
    report.page_table("stack", table, 2);
    report.fact("stack", "deepest_mm", deepest, 2);
    report.fact("stack", "drift_um_per_s", drift, 1);
}

}  // namespace enduring::chapter07
