#include "chapters/solvers/experiments.hpp"
#include "chapters/solvers/own_scene.hpp"

#include <memory>

int main(int argc, char** argv)
{
    using namespace enduring;
    const auto choice = std::make_shared<solvers::OwnSceneOptions>();
    ChapterProgram program{
        "solvers",
        "All solvers of the course side by side",
        {
            {"passes", "what every chapter's solver runs, stage by stage", solvers::passes},
            {"ledger", "every chapter's solver in every scene that called for a new one", solvers::ledger},
            {"speed",
             "how long chapter 7's steps take: against Bullet, over the number of bodies, against the clock",
             solvers::speed},
            {"own_scene", "the example of a scene of your own; any other runs with --scene FILE",
             solvers::own_scene_example},
        },
    };
    program.add_options = [choice](CLI::App& app) { solvers::add_own_scene_options(app, *choice); };
    program.own_scene = [choice](const RunOptions& options, Report& report) {
        solvers::own_scene(options, report, *choice);
    };
    return run_chapter(argc, argv, program);
}
