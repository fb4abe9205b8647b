#include "chapters/06_redefinition/solver.hpp"
#include "chapters/07_implicit_contact/experiments/experiments.hpp"
#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "common/experiments/render/film_probes.hpp"
#include "common/experiments/report/growing_table.hpp"
#include "common/experiments/run/run.hpp"

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
        cases.push_back({"1000 kg on 1 kg", stack_of(2, 1, 1000), dt});
        cases.push_back({"1 kg on 1000 kg", stack_of(2, 1000, 1), dt});
    }
    return cases;
}

/// The same boxes after some time under chapter 6's solver. With ten times this stiffness a step of 10 ms is
/// too long.
Scene after_chapter06(const Case& c, double duration)
{
    Scene scene = scene_of(c.boxes, c.dt);
    scene.contact.stiffness = 3000;
    run(scene, chapter06_solver(scene.contact), {},
        failure_on_purpose({.steps = static_cast<int>(duration / c.dt)}));
    return scene;
}

StripPicture picture_of(const Scene& scene, const std::string& caption)
{
    Stage stage = stage_of(scene.world, scene);
    stage.camera.eye = {9, 10, 24};
    stage.camera.target = {0, 9.8, 0};
    stage.camera.field_of_view_deg = 48;
    return {Renderer(320, 480).draw(stage), caption};
}

}  // namespace

/// Stacks of cubes, equal ones and 1000 : 1, for 20 s: no number is chosen for any of them.
void stack(const RunOptions& options, Report& report)
{
    GrowingTable table(report, "stack",
                       {"stack", "dt_s", "deepest_mm", "drift_um_per_s", "energy_gain_j", "max_newton_steps",
                        "newton_steps_at_rest", "unconverged", "solves"},
                       all_cases().size());
    std::vector<StripPicture> pictures;
    double deepest = 0, drift = 0;
    for (const Case& c : all_cases()) {
        Scene scene = scene_of(c.boxes, c.dt);
        const double duration = options.quick ? 2 : 20;
        const bool drawn = c.boxes.size() == 20 && c.dt == 0.01;
        if (drawn)
            pictures = {picture_of(after_chapter06(c, duration), "chapter 6, 3 kN/m")};
        const PileOutcome outcome = watch(scene, duration, chapter07_solver);
        if (drawn)
            pictures.push_back(picture_of(scene, "this chapter"));
        table.add({c.name, c.dt, outcome.deepest_mm, outcome.drift_um_per_s, outcome.energy_gain_j,
                   static_cast<long>(outcome.solves.max_newton_steps), outcome.newton_steps_at_rest,
                   outcome.solves.unconverged, outcome.solves.solves});
        deepest = std::max(deepest, outcome.deepest_mm);
        drift = std::max(drift, outcome.drift_um_per_s);
    }
    write_png(strip(pictures, 2), report.file("stack.png"));
    report.table("stack", table);
    report.page_table("stack", table, 2);
    report.fact("stack", "deepest_mm", deepest, 2);
    report.fact("stack", "drift_um_per_s", drift, 1);
}

}  // namespace enduring::chapter07
