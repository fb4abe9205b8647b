#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/experiments/random_scenes.hpp"

#include <algorithm>

namespace enduring::chapter08 {
namespace {

struct Tally {
    long scenes = 0, crossed = 0, steps_crossed = 0, parts = 0, badly = 0;
    double deepest = 0;
};

void run_scene(unsigned seed, Tally& tally)
{
    Scene scene = random_scene(seed);
    const long crossed = crossing_steps(scene, random_scene_steps, [&] {
        tally.deepest = std::max(tally.deepest, deepest_drawn(scene.world));
    });
    ++tally.scenes;
    tally.crossed += crossed > 0;
    tally.steps_crossed += crossed;
    tally.parts += scene.world.thrown_away;
    tally.badly += scene.world.ended_badly;
}

}  // namespace

/// Random scenes, judged after each step by what shares nothing with the search.
void crossings(const RunOptions& options, Report& report)
{
    const unsigned count = options.quick ? 60 : 1000;
    Tally rigid, soft;
    for (unsigned seed = 0; seed < count; ++seed)
        run_scene(seed, seed % 5 == 4 ? soft : rigid);
    Table table(
        {"bodies", "scenes", "scenes_that_cross", "deepest_drawn_per_mille", "thrown_away", "ended_badly"});
    for (const auto& [name, tally] : {std::pair("rigid", rigid), {"soft", soft}})
        table.add({name, tally.scenes, tally.crossed, 1000 * tally.deepest, tally.parts, tally.badly});
    report.table("crossings", table);
    report.page_table("crossings", table, 3);
    report.fact("crossings", "scenes", static_cast<double>(rigid.scenes + soft.scenes));
    report.fact("crossings", "cross", static_cast<double>(rigid.crossed + soft.crossed));
    report.fact("crossings", "deepest_drawn_per_mille", 1000 * std::max(rigid.deepest, soft.deepest), 2);
}

}  // namespace enduring::chapter08
