#pragma once

#include "common/experiments/report/chapter_program.hpp"
#include "common/simulation/contact_parameters.hpp"
#include "common/simulation/step.hpp"

#include <functional>
#include <string>

namespace enduring {

/// What may be chosen for a scene of the reader's own, besides what its file says.
struct OwnSceneOptions {
    std::string paraview = {};  ///< folder of the time series, empty for none
    int every = 1;              ///< steps from one moment of that series to the next
    std::string gltf = {};      ///< a file for the run as an animation, empty for none
    int save = 0;               ///< steps from one saved state to the next; 0 for none
    bool times = false;         ///< whether times.csv is written
    std::string resume = {};    ///< a saved state from which the run goes on, empty for the scene's start
};

using MakeSolver = std::function<Solver(const ContactParameters&)>;

/// The program, which now runs a scene of the reader's own as well: --scene FILE without an experiment, under
/// this solver, with --paraview, --every, --gltf, --save, --resume and --times.
ChapterProgram with_own_scenes(ChapterProgram program, MakeSolver make);
/// run_chapter() with it.
int run_chapter(int argc, char** argv, ChapterProgram program, MakeSolver make);

/// Runs the scene of options.scene and leaves energy, motion, penetration, contacts, joints where it has
/// some, and steps (StepCosts) as tables, which grow on the disk as the run goes, with choice.times also
/// times (StepTimes), the energy as a plot, six moments as a picture, a clip unless options.quick,
/// replay.json for the laboratory (Replay), and a summary on standard output. A run that breaks leaves the
/// same up to the step that broke it, and failed.txt, which says why. A run that is killed leaves
/// NAME.unfinished.csv of every table (Report::rows_so_far()), and with choice.save the last state in
/// state.json, from which choice.resume goes on.
/// @throws InputError          a mistake in the scene; a state that is not of this scene, or would be written
///     over; a solver that cannot resume
/// @throws std::runtime_error  a position or velocity became NaN or infinite, or energy came out of nothing
///     (see run())
void own_scene(const RunOptions& options, Report& report, const MakeSolver& make,
               const OwnSceneOptions& choice = {});

}  // namespace enduring
