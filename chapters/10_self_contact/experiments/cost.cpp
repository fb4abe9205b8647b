#include "chapters/10_self_contact/experiments/experiments.hpp"
#include "chapters/10_self_contact/experiments/soft_runs.hpp"
#include "chapters/10_self_contact/solver.hpp"
#include "common/experiments/run/run.hpp"

namespace enduring::chapter10 {

/// What looking for the bunny's contact with itself takes of the steps in which it falls into a bowl.
void cost(const RunOptions& options, Report& report)
{
    const int steps = options.quick ? 50 : 400;
    const auto timings_of = [&](bool self_contact) {
        Scene scene = load_scene(scene_file("bunny_bowl"),
                                 self_contact ? R"({"/bodies/bunny/self_contact": true})" : "");
        return run(scene, chapter10_solver(scene.contact), {}, {.steps = steps}).timings;
    };
    const Timings without = timings_of(false), with = timings_of(true);
    const double more = search_time(with) - search_time(without);
    report.fact("cost", "self_percent", 100 * more / with.total(), 2);
}

}  // namespace enduring::chapter10
