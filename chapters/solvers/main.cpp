#include "chapters/solvers/chapter_solver.hpp"
#include "chapters/solvers/experiments.hpp"
#include "common/experiments/own_scene/own_scene.hpp"

#include <CLI/CLI.hpp>

#include <memory>

int main(int argc, char** argv)
{
    using namespace enduring;
    const auto chapter = std::make_shared<int>(solvers::chapters);
    ChapterProgram program{
        "solvers",
        "All solvers of the course side by side",
        {
            {"passes", "what every chapter's solver runs, stage by stage", solvers::passes},
            {"ledger", "every chapter's solver in every scene that called for a new one", solvers::ledger},
            {"forces", "forces of pairs against statics and formulas: chapters 8 to 11", solvers::forces},
            {"speed",
             "how long chapter 7's steps take: against Bullet, over the number of bodies, against the clock",
             solvers::speed},
            {"soft_speed", "what steps of soft mats cost, with a dense block and with all their nodes",
             solvers::soft_speed},
            {"worst", "the slowest step of walls that are hit, spheres that are poured and two chains",
             solvers::worst},
            {"sizes", "steps of more and more cubes, spheres and elements, with one thread and with two",
             solvers::sizes},
            {"own_scene", "the example of a scene of your own; any other runs with --scene FILE",
             solvers::own_scene_example, takes_scene},
        },
    };
    program.add_options = [chapter](CLI::App& app) {
        app.add_option("--solver", *chapter, "the chapter whose solver runs a scene of your own")
            ->check(CLI::Range(1, solvers::last_chapter))
            ->capture_default_str()
            ->needs(app.get_option("--scene"))
            ->excludes(app.get_option("experiments"));
    };
    return run_chapter(argc, argv, program, [chapter](const ContactParameters& parameters) {
        return solvers::chapter_solver(*chapter, parameters);
    });
}
