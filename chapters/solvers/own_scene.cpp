#include "chapters/solvers/own_scene.hpp"

#include "chapters/06_redefinition/experiments/contact_census.hpp"
#include "chapters/motivating_scenes/motivating_scene.hpp"
#include "chapters/solvers/chapter_solver.hpp"
#include "chapters/solvers/experiments.hpp"
#include "common/experiments/paraview/series.hpp"
#include "common/experiments/render/film_probes.hpp"
#include "common/experiments/run/run.hpp"
#include "common/input/input_error.hpp"
#include "common/input/number_text.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <exception>
#include <iostream>
#include <memory>

namespace enduring::solvers {
namespace {

constexpr int pictures = 6, columns = 3;
constexpr const char* failure_note = "failed.txt";  // lies beside tables that end early, and says why

std::vector<double> picture_times(double duration)
{
    std::vector<double> times;
    times.reserve(pictures);
    for (int i = 0; i < pictures; ++i)
        times.push_back(duration * i / (pictures - 1));
    return times;
}

/// time_s, body, x_m ... vz_m_per_s: what MotionProbe says, of every body that moves.
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

/// Everything that watches the run, and what becomes of it.
class Observers {
public:
    Observers(const Scene& scene, const RunOptions& options, const OwnSceneOptions& choice, Report& report)
        : motion_(scene.world), penetration_(scene.contact.stiffness),
          strip_(scene, picture_times(scene.duration), motivating::mark_pairs, 560, 400)
    {
        if (!options.quick)
            clip_ = std::make_unique<ClipProbe>(scene, report.file("scene.webp"));
        if (!choice.paraview.empty())
            series_ = std::make_unique<ParaviewSeries>(choice.paraview, choice.every);
    }

    std::vector<Probe*> probes()
    {
        std::vector<Probe*> all{&energy_, &motion_, &penetration_, &census_, &inversion_, &strip_};
        if (clip_)
            all.push_back(clip_.get());
        if (series_)
            all.push_back(series_.get());
        return all;
    }

    void save(Report& report)
    {
        report.table("energy", energy_.table());
        report.table("motion", motion_.table());
        report.table("penetration", penetration_.table());
        report.table("contacts", census_.table());
        report.table("inverted", inversion_.table());
        report.plot("chapters/solvers/plots/own_scene.gp", "energy");
        write_png(strip_.all(columns), report.file("scene.png"));
        if (clip_)
            clip_->finish();
        if (series_)
            series_->finish();
    }

    void summarise(std::ostream& out, const std::string& solver, double dt) const
    {
        const long steps = static_cast<long>(energy_.table().rows().size()) - 1;
        out << '\n' << "    " << steps << " steps of " << shortest(dt) << " s, solver of " << solver << '\n';
        line(out, "pairs", penetration_.table(), 1, "");
        line(out, "deepest pair", penetration_.table(), 4, " m");
        line(out, "inverted elements", inversion_.table(), 1, "");
        line(out, "energy", energy_.table(), 4, " J");
        out << "    ";
    }

private:
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
    chapter06::ContactCensus census_;
    InversionProbe inversion_;
    StripProbe strip_;
    std::unique_ptr<ClipProbe> clip_;
    std::unique_ptr<ParaviewSeries> series_;
};

}  // namespace

void add_own_scene_options(CLI::App& app, OwnSceneOptions& choice)
{
    CLI::Option* const solver = app.add_option("--solver", choice.solver,
                                               "the chapter whose solver runs a scene of your own");
    solver->check(CLI::Range(1, chapters))->capture_default_str();
    CLI::Option* const paraview = app.add_option("--paraview", choice.paraview,
                                                 "folder for a time series of it that ParaView opens");
    paraview->type_name("DIR");
    CLI::Option* const every = app.add_option("--every", choice.every,
                                              "steps from one moment of that series to the next");
    every->check(CLI::PositiveNumber)->capture_default_str()->needs(paraview);
    for (CLI::Option* const option : {solver, paraview})
        option->needs(app.get_option("--scene"))->excludes(app.get_option("experiments"));
}

void own_scene_example(const RunOptions& options, Report& report)
{
    RunOptions own = options;
    own.scene = options.scene.value_or(scene_file("tumble"));
    Report below(report.folder() / own.scene->stem());
    own_scene(own, below, {});
    std::filesystem::copy_file(below.folder() / "scene.png", report.file("own_scene.png"),
                               std::filesystem::copy_options::overwrite_existing);
}

void own_scene(const RunOptions& options, Report& report, const OwnSceneOptions& choice)
{
    Scene scene = load_scene(options.scene.value());
    const Solver solver = chapter_solver(choice.solver, scene.contact);
    Observers observers(scene, options, choice, report);
    std::exception_ptr failure;
    std::filesystem::remove(report.folder() / failure_note);
    try {
        const RunResult result = run(scene, solver, observers.probes());
        std::cerr << "real-time factor " << readable(scene.world.time / result.timings.total(), 3)
                  << ", without pictures and files\n";
    } catch (const std::runtime_error& broken) {
        failure = std::current_exception();
        write_file(report.file(failure_note), std::string(broken.what()) + "\n");
    }
    observers.save(report);
    observers.summarise(std::cout, solver.name, scene.dt);
    if (failure)
        std::rethrow_exception(failure);
}

}  // namespace enduring::solvers
