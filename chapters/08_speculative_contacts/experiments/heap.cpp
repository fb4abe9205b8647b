#include "chapters/07_implicit_contact/solver.hpp"
#include "chapters/08_speculative_contacts/experiments/experiments.hpp"
#include "chapters/08_speculative_contacts/experiments/fall.hpp"
#include "chapters/08_speculative_contacts/solver.hpp"
#include "common/experiments/render/moments.hpp"

namespace enduring::chapter08 {

/// The same cubes dropped on a heap with this chapter's solver and with the one before.
void heap(const RunOptions& options, Report& report)
{
    struct Way {
        const char* name;
        MakeSolver make;
    };
    const int cubes = options.quick ? 8 : 30, side = options.quick ? 2 : 3;
    const double duration = options.quick ? 3 : 24;
    Table table({"solver", "cubes", "pairs", "deepest_mm", "speed_mm_per_s", "energy_gain_j",
                 "newton_steps_a_step", "unconverged"});
    for (const auto& [name, make] :
         {Way{"chapter 7", chapter07_solver}, Way{"chapter 8", chapter08_solver}}) {
        Scene scene = chapter07::scene_of(chapter07::loose_cubes(cubes, side, 1), 1.0 / 60);
        MomentsProbe moments(scene, {0, 1, duration - scene.dt}, mark_pairs);
        const FallOutcome outcome = watch(scene, duration, make, &moments);
        table.add({std::string(name), static_cast<long>(cubes), outcome.pairs, outcome.deepest_mm,
                   outcome.speed_mm_per_s, outcome.energy_gain_j, outcome.newton_steps,
                   outcome.solves.unconverged});
        if (make != static_cast<MakeSolver>(chapter08_solver))
            continue;
        constexpr int width = 480, height = 400;
        std::vector<Moment> shown = moments.moments();
        frame_each(shown, {0.6, 0.4, 1}, static_cast<double>(width) / height);
        write_png(draw_moments(shown, 3, width, height), report.file("heap.png"));
        report.fact("heap", "cubes", cubes);
        report.fact("heap", "pairs", static_cast<double>(outcome.pairs));
        report.fact("heap", "deepest_mm", outcome.deepest_mm, 2);
        report.fact("heap", "unconverged", static_cast<double>(outcome.solves.unconverged));
    }
    report.table("heap", table);
    report.page_table("heap", table, 2);
}

}  // namespace enduring::chapter08
