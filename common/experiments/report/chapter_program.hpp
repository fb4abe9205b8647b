#pragma once

#include "common/experiments/report/report.hpp"
#include "common/experiments/report/share.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;  // of CLI11, which takes two seconds to read: who adds options reads it
}

namespace enduring {

/// What the command line of a chapter's program settled.
struct RunOptions {
    /// --out, default build/results/NN_name; quick results never mix with full ones
    std::filesystem::path out;
    std::optional<std::filesystem::path> scene;  ///< --scene
    bool quick = false;                          ///< --quick: seconds instead of minutes, for a first look
    Share share;                                 ///< --parts, --part: of the runs of a sweep()
    bool pictures = true;                        ///< false with --no-pictures
};

/// One experiment of a chapter: a word for the command line, a line for --list, and the work.
struct Experiment {
    std::string name;
    std::string summary;
    std::function<void(const RunOptions&, Report&)> run;
    bool reads_scene = false;  ///< whether --scene FILE may stand for its own scene
};
/// The last word of an experiment that reads RunOptions::scene.
inline constexpr bool takes_scene = true;

struct ChapterProgram {
    std::string folder;  ///< "01_particle_plane"
    std::string title;
    std::vector<Experiment> experiments;
    /// Adds options of this chapter alone; a callback that returns true has
    /// done the work.
    std::function<void(CLI::App&)> add_options = {};
    std::function<bool(const RunOptions&)> instead_of_experiments = {};
    /// What --scene FILE without a word means: to run that scene, into its own folder
    /// (common/experiments/own_scene). With words, the file stands for the scenes of these experiments.
    std::function<void(const RunOptions&, Report&)> own_scene = {};
};

/// The conventional command line: experiment names, --scene FILE, --out DIR, --list, --quick, --help,
/// and --parts DIR, --part K/N for one share of a large experiment (sweep.hpp).
/// @return 0; 2 after a message on stderr for anything the user gave wrong
///     (unknown word, InputError); 1 for a failed run
int run_chapter(int argc, char** argv, const ChapterProgram& program);

}  // namespace enduring
