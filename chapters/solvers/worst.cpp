#include "chapters/08_contact_by_distance/experiments/random_scenes.hpp"
#include "chapters/10_self_contact/solver.hpp"
#include "chapters/solvers/experiments.hpp"
#include "chapters/solvers/worst_scenes.hpp"
#include "common/experiments/report/statistics.hpp"
#include "common/experiments/run/processor_clock.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/natural_units.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace enduring::solvers {
namespace {

/// What the steps of a run cost, each by itself.
struct WorstRun {
    std::vector<double> ms, newton_steps, pairs;
    long parts = 0, attempts = 0, ended_badly = 0;
    long crossings = 0;  ///< of the looks at the scene, those that find surfaces which cross
    double fastest = 0;  ///< at the end, of bodies [m/s]
    double depth = 0;    ///< of the deepest pair after any step, in sizes of its bodies [1]
    double gained = 0;   ///< the most that a step adds to the energy, over that at first [1]
};

/// A tenth: a look at the chain takes longer than a step. Ten times: what slips through each other comes out.
constexpr int steps_between_looks = 10;

WorstRun run_of(Scene& scene, double seconds)
{
    ImplicitSettings settings;
    settings.threads = 1;
    settings.record = [](const SolveRecord&) {};  // the table tells what is not solved
    const Solver solver = chapter10_solver(scene.contact, settings);
    Contacts contacts;
    WorstRun run;
    const double first = total_energy(scene.world).total();
    double before = first;
    for (int step = 0; step < std::lround(seconds / scene.dt); ++step) {
        const double start = processor_seconds();
        advance(scene.world, contacts, solver, scene.dt);
        run.ms.push_back(1000 * (processor_seconds() - start));
        run.pairs.push_back(static_cast<double>(contacts.size()));
        if ((step + 1) % steps_between_looks == 0)
            run.crossings += chapter08::any_crossing(scene.world);
        run.newton_steps.push_back(static_cast<double>(scene.world.work.newton_steps));
        run.parts += scene.world.work.parts;
        run.attempts += scene.world.work.attempts;
        for (const Contact& contact : contacts)
            if (contact.is_spring())
                run.depth = std::max(run.depth, -contact_geometry(scene.world, contact, 1).depth /
                                                    natural_length(scene.world, contact));
        const double energy = total_energy(scene.world).total();
        run.gained = std::max(run.gained, (energy - before) / std::abs(first));
        before = energy;
    }
    run.ended_badly = scene.world.ended_badly;
    for (const auto& body : scene.world.bodies)
        run.fastest = std::max(run.fastest, body->mean_velocity().norm());
    return run;
}

double most(const std::vector<double>& numbers) { return *std::max_element(numbers.begin(), numbers.end()); }

}  // namespace

/// Scenes whose slowest step is far slower than the others: what it costs, and what it has been halved for.
void worst(const RunOptions& options, Report& report)
{
    struct Case {
        Scene scene;
        double seconds;
    };
    std::vector<Case> cases;
    const bool quick = options.quick;
    cases.push_back({hit_wall(6, 10), quick ? 0.06 : 0.15});
    if (!quick) {
        cases.push_back({hit_wall(20, 15), 0.15});
        cases.push_back({hit_wall(41, 14), 0.15});
    }
    cases.push_back({poured_spheres(quick ? 20 : 200), quick ? 0.2 : 0.5});
    cases.push_back({hopper(quick ? 20 : 200), quick ? 0.2 : 0.5});
    cases.push_back({hanging_chain(quick ? 20 : 138), 0.2});
    cases.push_back({bicycle_chain(quick ? 12 : 138), quick ? 0.2 : 0.5});

    Table table({"scene", "steps", "mean [ms]", "worst [ms]", "Newton steps, mean", "Newton steps, worst",
                 "pairs", "parts", "attempts", "ended badly", "deepest over size", "crossing looks",
                 "fastest at the end [m/s]", "energy added"});
    double ratio = 0;
    long ended_badly = 0, crossings = 0;
    for (Case& one : cases) {
        const WorstRun run = run_of(one.scene, one.seconds);
        table.add({one.scene.name, static_cast<long>(run.ms.size()), mean(run.ms), most(run.ms),
                   mean(run.newton_steps), most(run.newton_steps), mean(run.pairs), run.parts, run.attempts,
                   run.ended_badly, run.depth, run.crossings, run.fastest, run.gained});
        ratio = std::max(ratio, most(run.ms) / mean(run.ms));
        ended_badly += run.ended_badly;
        crossings += run.crossings;
        if (&one == &cases.back()) {
            report.fact("worst", "bicycle_pairs", mean(run.pairs));
            report.fact("worst", "bicycle_newton_steps", mean(run.newton_steps), 2);
            report.fact("worst", "bicycle_um_per_s", 1e6 * run.fastest, 2);
            report.fact("worst", "bicycle_ms_by_clock", mean(run.ms), 2);
        }
    }
    report.table("worst", table);
    report.page_table("worst", table, 3);
    report.fact("worst", "most_over_mean_by_clock", ratio, 2);
    report.fact("worst", "ended_badly", static_cast<double>(ended_badly));
    report.fact("worst", "crossings", static_cast<double>(crossings));
}

}  // namespace enduring::solvers
