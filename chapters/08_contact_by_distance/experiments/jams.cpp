#include "chapters/07_implicit_contact/experiments/true_depth.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/experiments/jam_scenes.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/experiments/report/quantile.hpp"
#include "common/experiments/report/sweep.hpp"
#include "common/experiments/run/processor_clock.hpp"
#include "common/input/number_text.hpp"

#include <algorithm>
#include <array>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace enduring::chapter08 {
namespace {

/// Each step of a run is one of these.
constexpr int jam_steps = 100;

/// A mechanism of the solve, and how it is switched off.
struct Without {
    const char* name;
    void (*change)(ImplicitSettings&);
};
constexpr std::array withouts{
    Without{"nothing left out", [](ImplicitSettings&) {}},
    Without{"no mixing", [](ImplicitSettings& settings) { settings.mixing_rounds = 0; }},
    Without{"no search for limits",
            [](ImplicitSettings& settings) { settings.rounds_before_search = settings.max_newton_steps; }},
    Without{"no stiffness at once", [](ImplicitSettings& settings) {
                settings.stiffness.at_once = std::numeric_limits<double>::infinity();
            }}};

/// What a run came to. Plain numbers, to be kept by sweep().
struct JamOutcome {
    long unsolved = 0, halved = 0;  ///< steps
    double deepest_m = 0;           ///< chapter07::true_depth() after any step
    double seconds = 0;             ///< on the processor: for the screen, never for a table
    std::array<int, jam_steps> newton{};
};

JamOutcome run_jam(Scene scene, const Without& without)
{
    JamOutcome outcome;
    World& world = scene.world;
    Contacts contacts;
    int newton = 0;
    ImplicitSettings settings;
    without.change(settings);
    settings.record = [&](const SolveRecord& record) { newton += record.newton_steps; };
    const Solver solver = chapter08_solver(scene.contact, settings);
    for (int& of_step : outcome.newton) {
        newton = 0;
        const long thrown_away = world.thrown_away, ended_badly = world.ended_badly;
        const double begin = processor_seconds();
        advance(world, contacts, solver, scene.dt);
        outcome.seconds += processor_seconds() - begin;
        outcome.halved += world.thrown_away > thrown_away;
        outcome.unsolved += world.ended_badly > ended_badly;
        outcome.deepest_m = std::max(outcome.deepest_m, chapter07::true_depth(world));
        of_step = newton;
    }
    return outcome;
}

/// The runs of one kind of jam, or of all kinds, in one manner.
struct JamSummary {
    long runs = 0, unsolved = 0, halved = 0, newton = 0;
    double deepest_m = 0, seconds = 0;
    std::vector<int> of_steps;

    void add(const JamOutcome& run)
    {
        ++runs;
        unsolved += run.unsolved;
        halved += run.halved;
        deepest_m = std::max(deepest_m, run.deepest_m);
        seconds += run.seconds;
        of_steps.insert(of_steps.end(), run.newton.begin(), run.newton.end());
        for (const int steps : run.newton)
            newton += steps;
    }
};

std::vector<std::string> headed(std::vector<std::string> names, const std::vector<std::string>& columns)
{
    names.insert(names.end(), columns.begin(), columns.end());
    return names;
}

std::vector<Cell> row_of(std::vector<Cell> names, const JamSummary& sum)
{
    const auto steps = static_cast<long>(sum.of_steps.size());
    const std::vector<Cell> numbers{sum.runs,
                                    steps,
                                    sum.halved,
                                    sum.unsolved,
                                    long{quantile(sum.of_steps, 0.5)},
                                    long{quantile(sum.of_steps, 0.99)},
                                    long{quantile(sum.of_steps, 1)},
                                    static_cast<double>(sum.newton) / static_cast<double>(steps),
                                    1e3 * sum.deepest_m};
    names.insert(names.end(), numbers.begin(), numbers.end());
    return names;
}

}  // namespace

/// Bodies that jam, at random: how the steps are solved, and what each mechanism of the solve saves.
void jams(const RunOptions& options, Report& report)
{
    const std::size_t seeds = options.quick ? 3 : 40, scenes = all_jams.size() * seeds;
    const auto found = sweep<JamOutcome>(options, "jams", withouts.size() * scenes, [&](std::size_t i) {
        const std::size_t scene = i % scenes;
        return run_jam(random_jam(all_jams.at(scene / seeds), static_cast<unsigned>(1 + scene % seeds)),
                       withouts.at(i / scenes));
    });
    if (!found)
        return;
    const std::vector<std::string> columns{"scenes", "steps", "halved", "unsolved",    "Newton steps, median",
                                           "99 %",   "most",  "mean",   "deepest [mm]"};
    Table table(headed({"jam", "without"}, columns)), of_all(headed({"without"}, columns));
    for (std::size_t without = 0; without < withouts.size(); ++without) {
        const std::string name = withouts.at(without).name;
        JamSummary all;
        for (std::size_t jam = 0; jam < all_jams.size(); ++jam) {
            JamSummary sum;
            for (std::size_t seed = 0; seed < seeds; ++seed) {
                const JamOutcome& run = (*found)[without * scenes + jam * seeds + seed];
                sum.add(run);
                all.add(run);
            }
            table.add(row_of({name_of(all_jams.at(jam)), name}, sum));
        }
        of_all.add(row_of({name}, all));
        std::cout << "jams, " << name << ": "
                  << readable(1e3 * all.seconds / static_cast<double>(all.of_steps.size()), 3)
                  << " ms a step\n";
    }
    report.table("jams", table);
    report.page_table("jams", of_all, 2);
}

}  // namespace enduring::chapter08
