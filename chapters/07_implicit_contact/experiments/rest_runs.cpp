#include "chapters/07_implicit_contact/experiments/rest_runs.hpp"

#include "common/experiments/render/renderer.hpp"
#include "common/experiments/render/scene_view.hpp"

#include <algorithm>

namespace enduring::chapter07 {

bool is_at_rest(const PileOutcome& outcome)
{
    return outcome.drift_um_per_s < 10 && outcome.energy_gain_j <= 1e-6;
}

RestRuns::RestRuns(Report& report, const std::string& experiment, MakeSolver make, std::size_t count)
    : make_(make),
      table_(report, experiment,
             {"scene", "dt_s", "at_rest", "deepest_mm", "deepest_ever_mm", "moved_mm", "drift_um_per_s",
              "energy_gain_j", "max_newton_steps", "newton_steps_at_rest", "unconverged", "solves"},
             count)
{}

PileOutcome RestRuns::run(Case& c, Probe* observer)
{
    const PileOutcome outcome = watch(c.scene, c.duration, make_, observer);
    add(c, outcome);
    if (c.pictured) {
        Renderer renderer(480, 360);
        Stage stage = stage_of(c.scene.world, c.scene);
        stage.camera = frame(points_of(stage), c.seen_from, 480.0 / 360);
        ends_.push_back({renderer.draw(stage), c.name});
    }
    return outcome;
}

void RestRuns::add(const Case& c, const PileOutcome& outcome)
{
    const bool rests = is_at_rest(outcome) && outcome.moved_mm < c.kept_mm;
    table_.add({c.name, c.scene.dt, rests ? "yes" : "no", outcome.deepest_mm, outcome.deepest_ever_mm,
                outcome.moved_mm, outcome.drift_um_per_s, outcome.energy_gain_j,
                static_cast<long>(outcome.solves.max_newton_steps), outcome.newton_steps_at_rest,
                outcome.solves.unconverged, outcome.solves.solves});
    at_rest_ += rests;
    if (rests) {
        worst_.deepest_mm = std::max(worst_.deepest_mm, outcome.deepest_mm);
        worst_.drift_um_per_s = std::max(worst_.drift_um_per_s, outcome.drift_um_per_s);
    }
    unconverged_ += outcome.solves.unconverged;
    solves_ += outcome.solves.solves;
}

void RestRuns::report(const std::string& experiment, Report& report, int columns) const
{
    report.table(experiment, table_);
    report.page_table(experiment, table_, 2);
    write_png(strip(ends_, columns), report.file(experiment + ".png"));
    report.fact(experiment, "runs", static_cast<double>(table_.rows().size()));
    report.fact(experiment, "at_rest", static_cast<double>(at_rest_));
    report.fact(experiment, "deepest_mm", worst_.deepest_mm, 2);
    report.fact(experiment, "drift_um_per_s", worst_.drift_um_per_s, 2);
    report.fact(experiment, "unconverged", static_cast<double>(unconverged_));
    report.fact(experiment, "solves", static_cast<double>(solves_));
}

}  // namespace enduring::chapter07
