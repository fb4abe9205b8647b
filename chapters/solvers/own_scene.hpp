#pragma once

#include "chapters/solvers/chapter_solver.hpp"
#include "common/experiments/report/chapter_program.hpp"

#include <string>

namespace enduring::solvers {

/// What may be chosen for a scene of the reader's own, besides what its file says.
struct OwnSceneOptions {
    /// chapter whose solver runs it: 1 to 8 (that of chapter 2 finds collisions and answers none)
    int solver = chapters;
    std::string paraview;  ///< folder of the time series, empty for none
    int every = 1;         ///< steps from one moment of that series to the next
};

/// Adds --solver, --paraview and --every to the program's command line.
void add_own_scene_options(CLI::App& app, OwnSceneOptions& choice);

/// The example of the page on scenes, run as a scene of the reader's own: its results go to the folder
/// tumble, and the picture to the program's as well.
void own_scene_example(const RunOptions& options, Report& report);

/// Runs the scene of options.scene and leaves energy, motion, penetration and contacts as tables, the energy
/// as a plot, six moments as a picture, a clip unless options.quick, and a summary on standard output. A run
/// that breaks leaves the same up to the step that broke it, and failed.txt, which says why.
/// @throws InputError          a mistake in the scene
/// @throws std::runtime_error  a position or velocity became NaN or infinite, or energy came out of nothing (see run())
void own_scene(const RunOptions& options, Report& report, const OwnSceneOptions& choice);

}  // namespace enduring::solvers
