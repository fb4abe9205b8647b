#include "chapters/13_other_solvers/experiments/experiments.hpp"
#include "chapters/13_other_solvers/solver.hpp"
#include "common/experiments/own_scene/own_scene.hpp"

#include <CLI/CLI.hpp>

#include <memory>

int main(int argc, char** argv)
{
    using namespace enduring;
    const auto method = std::make_shared<std::string>("sequential");
    ChapterProgram program{
        "13_other_solvers",
        "Chapter 13: the other solvers",
        {
            {"same_scenes", "the rows of the page on engines under each method, and under ours beside them",
             chapter13::same_scenes},
            {"over_iterations", "what is left of a step in a stack and on a slope, over iterations",
             chapter13::over_iterations},
            {"soft_bodies", "soft scenes under the methods that have soft bodies, and under chapter 10",
             chapter13::soft_bodies},
            {"pair_forces", "forces of pairs against statics and momentum, under each method",
             chapter13::pair_forces},
            {"ledger_scenes", "the scenes of the failure ledger under each method", chapter13::ledger_scenes},
            {"heap", "cubes fall on a heap under each method: depth, drift, energy, time", chapter13::heap},
            {"bunny_bowl", "a soft bunny falls into a bowl under each method that has soft bodies",
             chapter13::bunny_bowl},
            {"growth", "the time of a step over the number of cubes, under each method", chapter13::growth},
            {"beside_engines", "methods with the settings of an engine, beside what that engine has done",
             chapter13::beside_engines},
        },
    };
    program.add_options = [method](CLI::App& app) {
        app.add_option(
               "--method", *method,
               "that runs a scene of your own: sequential, soft_step, relaxation, xpbd, avbd or barrier")
            ->needs(app.get_option("--scene"))
            ->excludes(app.get_option("experiments"));
    };
    return run_chapter(argc, argv, program, [method](const ContactParameters& parameters) {
        return chapter13_solver(*method, parameters);
    });
}
