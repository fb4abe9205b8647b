#include "chapters/05_categorisation/experiments/experiments.hpp"
#include "chapters/05_categorisation/experiments/hooked_pairs.hpp"
#include "chapters/05_categorisation/experiments/pair_census.hpp"
#include "common/experiments/run/run.hpp"

namespace enduring::chapter05 {

/// Thesis (6.3): which of the two rules calls a cube's upright edge against a floor's edge by its name?
void edge_rule(const RunOptions& options, Report& report)
{
    const std::filesystem::path file = options.scene.value_or(scene_file("hooked"));
    Table table({"rule", "hooked pairs", "EE regular a step", "EE hooked a step", "distance_m",
                 "speed at the end [m/s]"});
    for (const EdgeRule rule : {EdgeRule::both, EdgeRule::either})
        for (const HookedPairs treatment : {HookedPairs::pushed, HookedPairs::held}) {
            Scene scene = load_scene(file);
            CensusProbe probe("cube");
            run(scene, solver_that(treatment, rule, scene.contact), {&probe}, failure_on_purpose());
            const double steps = probe.steps();
            const std::string name = rule == EdgeRule::both ? "both" : "either",
                              done = treatment == HookedPairs::held ? "held" : "pushed";
            table.add({name, done, double(probe.total().edge_edge_regular) / steps,
                       double(probe.total().edge_edge_hooked) / steps, probe.way(), probe.last_speed()});
            report.fact("edge_rule", name + "_" + done + "_way", probe.way(), 3);
            report.fact("edge_rule", name + "_" + done + "_speed", probe.last_speed(), 3);
        }
    report.table("edge_rule", table);
    report.page_table("edge_rule", table);
}

}  // namespace enduring::chapter05
