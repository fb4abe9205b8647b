#include "common/experiments/report/chapter_program.hpp"

#include "common/experiments/report/pictures_wanted.hpp"
#include "common/experiments/report/progress.hpp"
#include "common/experiments/report/share.hpp"
#include "common/input/input_error.hpp"
#include "common/input/pending_file.hpp"
#include "common/input/source_directory.hpp"

#include <CLI/CLI.hpp>

#include <unistd.h>
#include <algorithm>
#include <csignal>
#include <iomanip>
#include <iostream>
#include <new>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace enduring {
namespace {

/// What the command line said, before anything was done about it.
struct CommandLine {
    std::vector<std::string> words;
    std::string out, scene, parts, part;
    bool help = false, list = false, quick = false, no_pictures = false;
};

/// "slope, mesh_slope": the experiments for which --scene FILE means something.
std::string names_of_scene_readers(const ChapterProgram& program)
{
    std::string names;
    for (const Experiment& experiment : program.experiments)
        if (experiment.reads_scene)
            names += (names.empty() ? "" : ", ") + experiment.name;
    return names;
}

/// An option with an empty text, as of a shell's variable that is not set, would be taken for one that was
/// not given.
void refuse_empty_texts(CLI::App& app)
{
    const auto not_empty = [](const std::string& text) {
        return text.empty() ? std::string("an empty text; a value is needed") : std::string();
    };
    for (CLI::Option* const option : app.get_options())
        if (option->get_expected_min() > 0)
            option->check(CLI::Validator(not_empty, ""));
}

void describe(CLI::App& app, const ChapterProgram& program, CommandLine& line)
{
    app.add_option("experiments", line.words, "experiments to run, all when none is named (see --list)");
    const std::string readers = names_of_scene_readers(program);
    app.add_option("--scene", line.scene,
                   (program.own_scene ? "a scene of your own" : std::string("a scene")) +
                       (readers.empty() ? "" : ", or instead of the one of " + readers))
        ->type_name("FILE");
    app.add_option("--out", line.out,
                   "folder for tables and pictures (default build/results/" + program.folder +
                       ", with --quick build/results-quick/...)")
        ->type_name("DIR");
    app.add_flag("--list", line.list, "name the experiments, one a line");
    app.add_flag("--quick", line.quick, "a small version: seconds instead of minutes");
    auto* const parts = app.add_option("--parts", line.parts,
                                       "folder that keeps what each run of a sweep has found");
    parts->type_name("DIR");
    app.add_option("--part", line.part, "run this share of a sweep alone, as in 2/8, and write no table")
        ->type_name("K/N")
        ->needs(parts);
    app.add_flag("--no-pictures", line.no_pictures, "tables alone: no pictures, plots or films");
    if (program.add_options)
        program.add_options(app);
    refuse_empty_texts(app);
}

std::size_t widest_name(const ChapterProgram& program)
{
    std::size_t width = 0;
    for (const Experiment& experiment : program.experiments)
        width = std::max(width, experiment.name.size());
    return width;
}

void list_experiments(const ChapterProgram& program, std::ostream& out)
{
    for (const Experiment& experiment : program.experiments)
        out << "  " << std::left << std::setw(static_cast<int>(widest_name(program))) << experiment.name
            << "  " << experiment.summary << '\n';
}

/// @throws InputError  a word that names no experiment
std::vector<const Experiment*> chosen(const ChapterProgram& program, const std::vector<std::string>& words)
{
    std::vector<const Experiment*> experiments;
    for (const std::string& word : words)
        if (std::none_of(program.experiments.begin(), program.experiments.end(),
                         [&](const Experiment& experiment) { return experiment.name == word; }))
            throw InputError("no experiment is called '" + word + "'");
    for (const Experiment& experiment : program.experiments)
        if (words.empty() || std::find(words.begin(), words.end(), experiment.name) != words.end())
            experiments.push_back(&experiment);
    return experiments;
}

/// Whether the command line asks for a scene of the reader's own, and not for an experiment.
bool is_own_scene(const ChapterProgram& program, const CommandLine& line)
{
    return program.own_scene && !line.scene.empty() && line.words.empty();
}

/// @throws InputError  the command line gives a scene to what reads none
void refuse_unread_scene(const ChapterProgram& program, const CommandLine& line)
{
    if (line.scene.empty() || is_own_scene(program, line))
        return;
    const std::string readers = names_of_scene_readers(program);
    const std::string others = (readers.empty() ? ", and no other does" : "; these do: " + readers) +
                               (program.own_scene ? ". Without an experiment named, the scene itself is run"
                                                  : "");
    if (line.words.empty())
        throw InputError("--scene: name the experiment that reads it. " +
                         (readers.empty() ? "None does" : "These do: " + readers));
    for (const Experiment* experiment : chosen(program, line.words))
        if (!experiment->reads_scene)
            throw InputError("--scene: '" + experiment->name + "' reads no scene file" + others);
}

RunOptions options_of(const ChapterProgram& program, const CommandLine& line)
{
    RunOptions options;
    options.out = line.out;
    if (line.out.empty()) {
        options.out = source_directory() / "build" / (line.quick ? "results-quick" : "results") /
                      program.folder;
        if (is_own_scene(program, line))
            options.out /= std::filesystem::path(line.scene).stem();
    }
    if (!line.scene.empty())
        options.scene = line.scene;
    options.quick = line.quick;
    options.share = read_share(line.parts, line.part);
    options.pictures = !line.no_pictures;
    return options;
}

void run_telling(const Experiment& experiment, const RunOptions& options, Report& report)
{
    const std::string name =
        std::filesystem::path(experiment.name).stem().string();  // it may be a scene's file
    const std::string part = options.share.is_part() ? "." + std::to_string(options.share.which) : "";
    const Progress whole(name);
    const ProgressFile file(report.folder() / (name + part + ".progress.txt"));
    experiment.run(options, report);
}

void run_experiments(const ChapterProgram& program, const std::vector<const Experiment*>& experiments,
                     const RunOptions& options)
{
    std::cout << program.title << ": " << options.out.lexically_normal().string() << std::endl;
    for (const Experiment* experiment : experiments) {
        const auto say_name = [&] {
            std::cout << "  " << std::left << std::setw(static_cast<int>(widest_name(program)))
                      << experiment->name << "  " << std::flush;
        };
        say_name();
        Report report(options.out);
        run_telling(*experiment, options, report);
        if (options.share.is_part() && !report.written().empty())
            throw InputError("--part: " + experiment->name + " has no parts");
        if (isatty(STDOUT_FILENO))  // the progress stood in the same line
            std::cout << '\r', say_name();
        for (const std::filesystem::path& file : report.written())
            if (std::filesystem::exists(file))
                std::cout << file.filename().string() << ' ';
        std::cout << std::endl;
    }
}

void run_what_is_asked(const ChapterProgram& program, const CommandLine& line,
                       const std::vector<const Experiment*>& experiments)
{
    const RunOptions options = options_of(program, line);
    want_pictures(options.pictures);
    const Experiment own_scene{line.scene, "", program.own_scene};
    if (is_own_scene(program, line))
        run_experiments(program, {&own_scene}, options);
    else if (!program.instead_of_experiments || !program.instead_of_experiments(options))
        run_experiments(program, experiments, options);
}

/// A file that may not grow (ulimit -f) is an error of its writer, which is told, and not the end of the
/// program.
void tell_of_full_files() { std::signal(SIGXFSZ, SIG_IGN); }

/// What a program printed is a result, too: onto a full disk it does not get.
/// @throws std::runtime_error  it did not
void require_printed()
{
    if (!std::cout.flush())
        throw std::runtime_error("the standard output cannot be written to its end (is the disk full?)");
}

/// A step of a solver asks for the memory that the step before has given back. To hand it to the system in
/// between costs more than half of the time of a small step.
void keep_freed_memory()
{
#ifdef __GLIBC__
    constexpr int much = 1 << 28;
    mallopt(M_TRIM_THRESHOLD, much);
    mallopt(M_MMAP_THRESHOLD, much / 8);
#endif
}

}  // namespace

int run_chapter(int argc, char** argv, const ChapterProgram& program)
{
    keep_freed_memory();
    tell_of_full_files();
    CLI::App app(program.title, std::filesystem::path(argv[0]).filename().string());
    CommandLine line;
    describe(app, program, line);
    const auto usage = [&](const std::string& mistake) {
        std::cerr << app.get_name() << ": " << mistake << "\n\n" << app.help() << "\nExperiments:\n";
        list_experiments(program, std::cerr);
        return 2;
    };
    std::vector<const Experiment*> experiments;
    try {
        app.parse(argc, argv);
        experiments = chosen(program, line.words);
        refuse_unread_scene(program, line);
    } catch (const CLI::CallForHelp&) {
        line.help = true;
    } catch (const CLI::ParseError& mistake) {
        return usage(mistake.what());
    } catch (const InputError& mistake) {
        return usage(mistake.what());
    }

    PendingFile::cleaned_on_interrupt();
    try {
        if (line.help)
            std::cout << app.help() << "\nExperiments:\n";
        if (line.help || line.list)
            list_experiments(program, std::cout);
        else
            run_what_is_asked(program, line, experiments);
        require_printed();
        return 0;
    } catch (const InputError& mistake) {
        std::cout << std::endl;
        std::cerr << app.get_name() << ": " << mistake.what() << '\n';
        return 2;
    } catch (const std::bad_alloc&) {
        std::cout << std::endl;
        std::cerr << app.get_name() << ": failed: there is not enough memory\n";
        return 1;
    } catch (const std::exception& failure) {
        std::cout << std::endl;
        std::cerr << app.get_name() << ": failed: " << failure.what() << '\n';
        return 1;
    }
}

}  // namespace enduring
