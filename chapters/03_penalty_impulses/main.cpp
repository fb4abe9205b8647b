#include "chapters/03_penalty_impulses/experiments/experiments.hpp"
#include "chapters/03_penalty_impulses/solver.hpp"
#include "common/experiments/own_scene/own_scene.hpp"

#include <CLI/CLI.hpp>

#include <memory>

int main(int argc, char** argv)
{
    using namespace enduring;
    auto elements = std::make_shared<int>(785);
    ChapterProgram program{
        "03_penalty_impulses",
        "Chapter 3: penalty impulses",
        {
            {"impulse_shape", "depth over a step, and what each method integrates (thesis figure 5.1)",
             chapter03::impulse_shape},
            {"normalisation", "what the constant length L_k costs, over how far a face turns in a step",
             chapter03::normalisation},
            {"bar_on_cube",
             "a soft bar on a rigid cube: force, jitter, the largest smooth step (thesis figures 7.3-7.5)",
             chapter03::bar_on_cube, takes_scene},
            {"penetration", "summed depth over step and stiffness (thesis figures 7.6-7.7)",
             chapter03::penetration, takes_scene},
            {"bunny_bowl",
             "a soft bunny falls into a rigid bowl (thesis figure 7.13); --elements 363, 785, 1452 or 10668",
             [elements](const RunOptions& options, Report& report) {
                 chapter03::bunny_bowl(options, report, *elements);
             },
             takes_scene},
            {"hooked", "a cube that slides over triangles stops (thesis 6.1.2)", chapter03::hooked,
             takes_scene},
        },
    };
    program.add_options = [elements](CLI::App& app) {
        app.add_option("--elements", *elements, "elements of the bunny in bunny_bowl")
            ->check(CLI::IsMember({363, 785, 1452, 10668}))
            ->capture_default_str();
    };
    return run_chapter(argc, argv, program, chapter03_solver);
}
