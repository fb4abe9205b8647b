#include "chapters/11_exact_contact/experiments/experiments.hpp"
#include "chapters/11_exact_contact/problem_of_step.hpp"
#include "chapters/11_exact_contact/solver.hpp"
#include "common/experiments/own_scene/own_scene.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

int main(int argc, char** argv)
{
    using namespace enduring;
    const auto more = std::make_shared<std::filesystem::path>();
    const auto written = std::make_shared<std::filesystem::path>();
    const auto as_fclib = std::make_shared<bool>(false);
    const auto seed = std::make_shared<unsigned>(0);
    ChapterProgram program{
        "11_exact_contact",
        "Chapter 11: exact contact",
        {
            {"spring_error", "how far springs are from exact contact, over their stiffness and over passes",
             chapter11::spring_error},
            {"scoreboard",
             "public problems of contact, and those in a folder of yours (--problems), beside Siconos",
             [more](const RunOptions& options, Report& report) {
                 chapter11::scoreboard(options, report, *more);
             }},
            {"own_problems", "problems of our own scenes for others, written with our answers",
             chapter11::own_problems},
            {"generated",
             "54 problems that rules make (others with --seed), written with our answers: towers, packings, graphs",
             [seed](const RunOptions& options, Report& report) {
                 chapter11::generated(options, report, *seed);
             }},
            {"score_sets",
             "solved problems and times beside Siconos: public, our scenes', of rules, and held out (--seed)",
             [more, seed](const RunOptions& options, Report& report) {
                 chapter11::score_sets(options, report, *more, std::max(1U, *seed));
             }},
            {"stack_exact", "a stack at rest on springs that remember their force: how deep it is pressed",
             chapter11::stack_exact},
            {"exact_scenes", "scenes at rest on springs and on springs that remember: depth, drift and time",
             chapter11::exact_scenes},
            {"relaxation",
             "what the convex relaxation of Coulomb's rule lifts, and Painleve's rod under the rule itself",
             chapter11::relaxation},
        },
    };
    program.add_options = [more, written, as_fclib, seed](CLI::App& app) {
        app.add_option("--problems", *more,
                       "a folder of FCLIB's or Siconos' problems for scoreboard and score_sets")
            ->type_name("DIR");
        app.add_option("--seed", *seed, "of the problems that rules make, for generated and score_sets")
            ->check(CLI::Range(0U, 1'000'000U));
        CLI::Option* const writes = app.add_option(
            "--write-problems", *written,
            "folder for the problem of each step of your scene and its answer, as Siconos' text");
        writes->type_name("DIR")->needs(app.get_option("--scene"))->excludes(app.get_option("experiments"));
        app.add_flag("--fclib", *as_fclib, "writes them as FCLIB's HDF5")->needs(writes);
    };
    return run_chapter(argc, argv, program, [written, as_fclib](const ContactParameters& parameters) {
        Solver solver = chapter11_solver(parameters);
        if (!written->empty())
            write_problems(solver, parameters, *written,
                           *as_fclib ? ProblemForm::fclib : ProblemForm::siconos);
        return solver;
    });
}
