#include "chapters/07_implicit_contact/experiments/depth_runs.hpp"
#include "chapters/07_implicit_contact/experiments/experiments.hpp"
#include "chapters/07_implicit_contact/experiments/rest_scenes.hpp"
#include "chapters/07_implicit_contact/solver.hpp"

#include <algorithm>

namespace enduring::chapter07 {
namespace {

struct Defeat {
    std::string name;
    Scene scene;
    double duration;  ///< [s]
};

/// Four small cubes, each laid exactly on the one below: rounding puts some of their corners inside.
Scene laid_cubes(double size, double dt)
{
    std::vector<Box> boxes = stack_of(4);
    for (Box& box : boxes) {
        box.centre *= size;
        box.size *= size;
        box.mass *= size * size * size;
    }
    return scene_of(boxes, dt);
}

std::vector<Defeat> all_defeats(double dt, bool quick)
{
    std::vector<Defeat> all;
    all.push_back({"spike of 33° in a crack of 60°", tip_in_crack(Tip::spike, 33, 60, dt), 4});
    all.push_back({"wedge of 33° in a crack of 60°", tip_in_crack(Tip::wedge, 33, 60, dt), 4});
    all.push_back({"wedge on an edge", wedge_on_edge(dt), 4});
    all.push_back({"four cubes of 1 cm, laid exactly", laid_cubes(0.01, dt), 1});
    const int cubes = quick ? 8 : 30;
    all.push_back({"heap of " + std::to_string(cubes) + " cubes",
                   scene_of(loose_cubes(cubes, quick ? 2 : 3, 3), dt), quick ? 2.0 : 8.0});
    return all;
}

}  // namespace

/// Scenes that chapter 6's pairs do not carry, however well their problem is solved: how deep bodies come
/// into each other, whatever the pairs say.
void defeated(const RunOptions& options, Report& report)
{
    Table table({"scene", "dt_s", "deepest_mm", "at_the_end_mm", "unsolved", "solves"});
    double deepest = 0;
    for (const double dt : {0.01, 1.0 / 60})
        for (Defeat& defeat : all_defeats(dt, options.quick)) {
            const DepthOutcome outcome = measure_depths(defeat.scene, defeat.duration, chapter07_solver);
            table.add({defeat.name, dt, 1e3 * outcome.deepest_m, 1e3 * outcome.at_end_m, outcome.unsolved,
                       outcome.solves});
            deepest = std::max(deepest, 1e3 * outcome.deepest_m);
        }
    report.table("defeated", table);
    report.page_table("defeated", table, 2);
    report.fact("defeated", "deepest_mm", deepest, 2);
}

}  // namespace enduring::chapter07
