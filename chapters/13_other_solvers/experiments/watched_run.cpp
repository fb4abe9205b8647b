#include "chapters/13_other_solvers/experiments/watched_run.hpp"

#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/experiments/true_depth.hpp"
#include "common/experiments/run/processor_clock.hpp"
#include "common/input/input_error.hpp"
#include "common/simulation/energy.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::chapter13 {
namespace {

/// Steps a scene, and tells what comes of it.
void run_and_watch(Scene& scene, const Solver& solver, const Watch& watch, WatchedRun& run)
{
    const long steps = std::lround(watch.seconds / scene.dt), late = steps - std::max(1L, steps / 10),
               first = std::lround(watch.from / scene.dt);
    const double first_energy = total_energy(scene.world).total();
    double lowest = first_energy;
    std::vector<Vec3> before = chapter07::centres_of(scene.world);
    Contacts contacts;
    double used = 0;
    for (long step = 1; step <= steps && used < watch.budget_s; ++step) {
        const double start = processor_seconds();
        advance(scene.world, contacts, solver, scene.dt);
        const double seconds = processor_seconds() - start;
        used += seconds;
        if (step > first)
            run.step_ms += 1000 * seconds;
        run.reached_s = static_cast<double>(step) * scene.dt;
        const double energy = total_energy(scene.world).total();
        lowest = std::min(lowest, energy);
        run.gained_j = std::max(run.gained_j, energy - lowest);
        if (step == late)
            before = chapter07::centres_of(scene.world);
        if (watch.depths > 0 && (step % watch.depths == 0 || step == steps)) {
            run.deepest_end_mm = 1e3 * chapter07::true_depth(scene.world);
            run.deepest_mm = std::max(run.deepest_mm, run.deepest_end_mm);
        }
    }
    run.lost_j = first_energy - lowest;
    const long taken = std::lround(run.reached_s / scene.dt);
    run.step_ms /= static_cast<double>(std::max(1L, taken - first));
    run.drift_mm_per_s = 1e3 * chapter07::longest_displacement(scene.world, before) /
                         (static_cast<double>(steps - late) * scene.dt);
}

}  // namespace

WatchedRun watch_run(Scene scene, const MakeMethod& make, const Watch& watch)
{
    WatchedRun run;
    try {
        const Solver solver = make(scene.contact);
        run_and_watch(scene, solver, watch, run);
    } catch (const InputError& refusal) {
        const std::string why = refusal.what();
        std::copy_n(why.begin(), std::min(why.size(), run.reason.size() - 1), run.reason.begin());
    }
    return run;
}

}  // namespace enduring::chapter13
