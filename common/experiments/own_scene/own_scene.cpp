#include "common/experiments/own_scene/own_scene.hpp"

#include "common/experiments/gltf/animation.hpp"
#include "common/experiments/own_scene/replay.hpp"
#include "common/experiments/paraview/series.hpp"
#include "common/experiments/render/run_pictures.hpp"
#include "common/experiments/report/warn_once.hpp"
#include "common/experiments/run/contact_census.hpp"
#include "common/experiments/run/joint_probe.hpp"
#include "common/experiments/run/run.hpp"
#include "common/experiments/run/saved_run.hpp"
#include "common/input/input_error.hpp"
#include "common/input/number_text.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>

namespace enduring {
namespace {

constexpr const char* state_file = "state.json";
constexpr const char* replay_file = "replay.json";
constexpr const char* failure_note = "failed.txt";  // lies beside tables that end early, and says why

/// time_s, body, x_m ... vz_m_per_s: what MotionProbe says of the centre of mass of every body that moves.
class MotionOfAll final : public TableProbe {
public:
    explicit MotionOfAll(const World& world)
        : TableProbe({"time_s", "body", "x_m", "y_m", "z_m", "vx_m_per_s", "vy_m_per_s", "vz_m_per_s"})
    {
        for (const auto& body : world.bodies)
            if (!body->is_static())
                moving_.emplace_back(body->name(), MotionProbe(body->name()));
    }
    void observe(const World& world, const Contacts& contacts, double dt) override
    {
        for (auto& [name, probe] : moving_) {
            probe.observe(world, contacts, dt);
            std::vector<Cell> row = probe.table().rows().back();
            row.insert(row.begin() + 1, name);
            table_.add(std::move(row));
        }
    }

private:
    std::vector<std::pair<std::string, MotionProbe>> moving_;
};

/// Saves where the run stands, every so many steps.
class SaveProbe final : public Probe {
public:
    SaveProbe(World& world, int every, std::filesystem::path file)
        : world_(world), every_(every), file_(std::move(file))
    {}
    void observe(const World& world, const Contacts& contacts, double) override
    {
        if (world.step % every_ == 0)
            save_run(file_, world_, contacts);
    }

private:
    World& world_;  ///< the one that is watched: a state is read and written by one function
    int every_;
    std::filesystem::path file_;
};

/// @throws InputError  what is asked for cannot be done
void check(const OwnSceneOptions& choice, const Solver& solver, const Report& report)
{
    if ((choice.save > 0 || !choice.resume.empty()) && !solver.can_resume)
        throw InputError("--save and --resume: the solver of " + solver.name +
                         " remembers more than world and pairs hold; those from chapter 8 on do not");
    if (!choice.resume.empty() &&
        std::filesystem::weakly_canonical(std::filesystem::path(choice.resume).parent_path()) ==
            std::filesystem::weakly_canonical(report.folder()))
        throw InputError(
            "--resume: '" + choice.resume +
            "' lies beside the tables of its run, which would be written over; name another folder with --out");
}

/// A state is of a step of this scene: what else would the run count to its end from?
/// @throws InputError  it is not
void check_resumed(const Scene& scene, const std::string& file)
{
    const int last = step_count(scene);
    if (scene.world.step > last)
        throw InputError(file + ": /step: is " + std::to_string(scene.world.step) +
                         ", and the scene ends after " + std::to_string(last) + " steps");
    if (const double time = scene.world.step * scene.dt; std::abs(scene.world.time - time) > scene.dt / 2)
        throw InputError(file + ": /time: is " + shortest(scene.world.time) + " s, and step " +
                         std::to_string(scene.world.step) + " of the scene ends at " + shortest(time) + " s");
}

/// Everything that watches the run, and what becomes of it.
class Observers {
public:
    Observers(const Scene& scene, const Solver& solver, const RunOptions& options,
              const OwnSceneOptions& choice, Report& report)
        : motion_(scene.world), penetration_(scene.contact.stiffness), first_(scene.world.step + 1),
          filmed_(!options.quick), pictures_(scene, {.filmed = filmed_}), replay_(scene, solver.name),
          replayed_(options.pictures), tables_([this, &report](const World&, const Contacts&, double) {
              for (const auto& [name, table] : all_tables())
                  report.rows_so_far(name, *table);
          })
    {
        if (!scene.world.joints.empty())
            watching_.push_back(&joints_.emplace());
        if (choice.times)
            watching_.push_back(&times_.emplace(solver));
        if (options.pictures)
            watching_.insert(watching_.end(), {&pictures_, &replay_});
        if (!choice.paraview.empty())
            watching_.push_back(&series_.emplace(choice.paraview, choice.every));
        if (!choice.gltf.empty())
            watching_.push_back(&animation_.emplace(scene, choice.gltf));
        watching_.push_back(&tables_);
    }
    Observers(const Observers&) = delete;  // the probes know where they are
    Observers& operator=(const Observers&) = delete;

    const std::vector<Probe*>& probes() const { return watching_; }
    StepTimes* times() { return times_ ? &*times_ : nullptr; }

    void save(Report& report)
    {
        for (const auto& [name, table] : all_tables())
            report.table(name, *table);
        if (!times_)
            std::filesystem::remove(report.folder() / "times.csv");  // of an earlier run
        if (!joints_)
            std::filesystem::remove(report.folder() / "joints.csv");
        report.plot("common/experiments/own_scene/plots/own_scene.gp", "energy");
        write_png(pictures_.strip_of_all(3), report.file("scene.png"));
        if (filmed_)
            pictures_.write_film(report.file("scene.webp"));
        if (replayed_)
            replay_.write(report.file(replay_file));
        else
            std::filesystem::remove(report.folder() / replay_file);  // of an earlier run
        if (series_)
            series_->finish();
        if (animation_)
            animation_->finish();
    }

    void summarise(std::ostream& out, const std::string& solver, double dt) const
    {
        const long steps = static_cast<long>(energy_.table().rows().size()) - 1;
        out << '\n' << "    " << steps << " steps of " << shortest(dt) << " s, solver of " << solver << '\n';
        line(out, "pairs", penetration_.table(), 1, "");
        line(out, "deepest pair", penetration_.table(), 4, " m");
        line(out, "energy", energy_.table(), 4, " J");
        if (steps > 0)
            tell_costs(out);
        out << "    ";
    }

private:
    std::vector<std::pair<const char*, const Table*>> all_tables() const
    {
        std::vector<std::pair<const char*, const Table*>> tables{{"energy", &energy_.table()},
                                                                 {"motion", &motion_.table()},
                                                                 {"penetration", &penetration_.table()},
                                                                 {"contacts", &census_.table()},
                                                                 {"steps", &costs_.table()}};
        if (joints_)
            tables.emplace_back("joints", &joints_->table());
        if (times_)
            tables.emplace_back("times", &times_->table());
        return tables;
    }

    /// What the run's steps cost: the numbers on `out` are the same for each run, those of a clock are told
    /// on stderr.
    void tell_costs(std::ostream& out) const
    {
        const std::vector<double> newton = costs_.column("newton_steps"),
                                  inverted = costs_.column("inverted_elements");
        const auto sum = [&](const std::string& of) {
            const std::vector<double> numbers = costs_.column(of);
            return readable(std::accumulate(numbers.begin(), numbers.end(), 0.0), 4);
        };
        const bool is_implicit = std::any_of(newton.begin(), newton.end(), [](double n) { return n > 0; });
        out << "    " << (is_implicit ? "Newton steps" : "responses")
            << " of a step: " << mean_and_worst(is_implicit ? newton : costs_.column("responses"), "", first_)
            << '\n';
        out << "    " << sum("attempts") << " attempts, " << sum("parts") << " parts kept; "
            << sum("ended_badly") << " ended badly, " << sum("unsolved") << " islands unsolved\n";
        if (times_)
            std::cerr << "processor time of a step: " << mean_and_worst(times_->totals(), " ms", first_)
                      << '\n';
        const auto most = std::max_element(inverted.begin(), inverted.end());
        if (*most > 0)
            warn_once(
                readable(*most, 4) + " elements were inside out after step " +
                std::to_string(first_ + (most - inverted.begin())) + ", the most of all steps, and " +
                readable(inverted.back(), 4) +
                " at the end: such elements push from the wrong side, so make dt shorter or the mesh finer");
    }
    static double number(const Cell& cell)
    {
        return std::holds_alternative<long>(cell) ? static_cast<double>(std::get<long>(cell))
                                                  : std::get<double>(cell);
    }

    static void line(std::ostream& out, const std::string& what, const Table& table, std::size_t column,
                     const std::string& unit)
    {
        double most = number(table.rows().front()[column]);
        for (const std::vector<Cell>& row : table.rows())
            most = std::max(most, number(row[column]));
        out << "    " << what << ": " << readable(number(table.rows().back()[column]), 4) << unit
            << " at the end, " << readable(most, 4) << unit << " at most\n";
    }

    EnergyProbe energy_;
    MotionOfAll motion_;
    PenetrationProbe penetration_;
    ContactCensus census_;
    StepCosts costs_;
    std::optional<JointProbe> joints_;
    std::optional<StepTimes> times_;
    int first_;  ///< number of the first step
    bool filmed_;
    RunPictures pictures_;
    Replay replay_;
    bool replayed_;
    std::optional<ParaviewSeries> series_;
    std::optional<GltfAnimation> animation_;
    WatchProbe tables_;  ///< puts the rows of this step on the disk
    std::vector<Probe*> watching_{&energy_, &motion_, &penetration_, &census_, &costs_};
};

}  // namespace

ChapterProgram with_own_scenes(ChapterProgram program, MakeSolver make)
{
    const auto choice = std::make_shared<OwnSceneOptions>();
    program.own_scene = [choice, make = std::move(make)](const RunOptions& options, Report& report) {
        own_scene(options, report, make, *choice);
    };
    program.add_options = [choice, others = program.add_options](CLI::App& app) {
        if (others)
            others(app);
        CLI::Option* const paraview = app.add_option(
            "--paraview", choice->paraview, "folder for a time series of your scene that ParaView opens");
        paraview->type_name("DIR")->needs(app.get_option("--scene"))->excludes(app.get_option("experiments"));
        app.add_option("--every", choice->every, "steps from one moment of that series to the next")
            ->check(CLI::Range(1, std::numeric_limits<int>::max()))
            ->capture_default_str()
            ->needs(paraview);
        app.add_option("--gltf", choice->gltf,
                       "a file .glb for your scene as an animation, for Blender, f3d or a page")
            ->type_name("FILE")
            ->needs(app.get_option("--scene"))
            ->excludes(app.get_option("experiments"));
        app.add_option("--save", choice->save,
                       "steps after which the state is saved again, as state.json in the results")
            ->check(CLI::Range(1, std::numeric_limits<int>::max()))
            ->needs(app.get_option("--scene"))
            ->excludes(app.get_option("experiments"));
        app.add_flag("--times", choice->times,
                     "times.csv: what each step took of the processors, in search, query and solve")
            ->needs(app.get_option("--scene"))
            ->excludes(app.get_option("experiments"));
        app.add_option("--resume", choice->resume,
                       "a state.json of the same scene, from which the run goes on")
            ->type_name("FILE")
            ->needs(app.get_option("--scene"))
            ->excludes(app.get_option("experiments"));
    };
    return program;
}

int run_chapter(int argc, char** argv, ChapterProgram program, MakeSolver make)
{
    return run_chapter(argc, argv, with_own_scenes(std::move(program), std::move(make)));
}

void own_scene(const RunOptions& options, Report& report, const MakeSolver& make,
               const OwnSceneOptions& choice)
{
    Scene scene = load_scene(options.scene.value());
    const Solver solver = make(scene.contact);
    require_asked(scene, solver);
    check(choice, solver, report);
    RunLimits limits;
    if (!choice.resume.empty()) {
        limits.contacts = resume_run(choice.resume, scene.world);
        check_resumed(scene, choice.resume);
    }
    Observers observers(scene, solver, options, choice, report);
    limits.times = observers.times();
    std::vector<Probe*> probes = observers.probes();
    std::optional<SaveProbe> save;
    if (choice.save > 0)
        probes.push_back(&save.emplace(scene.world, choice.save, report.folder() / state_file));
    std::exception_ptr failure;
    std::filesystem::remove(report.folder() / failure_note);
    try {
        const RunResult result = run(scene, solver, probes, limits);
        std::cerr << "real-time factor " << readable(scene.world.time / result.timings.total(), 3)
                  << ", without pictures and files\n";
    } catch (const InputError&) {
        throw;  // a place that cannot be written: what stands in the tables stays there
    } catch (const std::runtime_error& broken) {
        failure = std::current_exception();
        write_file(report.file(failure_note), std::string(broken.what()) + "\n");
    }
    observers.save(report);
    observers.summarise(std::cout, solver.name, scene.dt);
    if (failure)
        std::rethrow_exception(failure);
}

}  // namespace enduring
