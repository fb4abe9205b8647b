#include "chapters/09_deep_contacts/experiments/experiments.hpp"
#include "chapters/09_deep_contacts/solver.hpp"
#include "common/experiments/run/run.hpp"

namespace enduring::chapter09 {

/// What tracing takes of the steps in which a bunny falls into a bowl.
void cost(const RunOptions& options, Report& report)
{
    Scene scene = load_scene(scene_file("bunny_bowl"));
    const int steps = options.quick ? 50 : 400;
    const RunResult result = run(scene, chapter09_solver(scene.contact), {}, {.steps = steps});
    const auto tell = [&](const std::string& name, const std::string& pass) {
        report.fact("cost", name + "_ms", 1000 * result.timings.of(pass) / steps, 2);
        report.fact("cost", name + "_percent", 100 * result.timings.of(pass) / result.timings.total(), 2);
    };
    tell("tracing", "trace overlaps");
    tell("search", "find pairs");
    report.fact("cost", "step_ms", 1000 * result.timings.total() / steps, 2);
}

}  // namespace enduring::chapter09
