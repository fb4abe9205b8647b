#include "common/experiments/run/run.hpp"

#include "common/experiments/report/progress.hpp"
#include "common/experiments/report/warn_once.hpp"
#include "common/experiments/run/energy_budget.hpp"

#include <stdexcept>

namespace enduring {

RunResult run(Scene& scene, const Solver& solver, const std::vector<Probe*>& probes, const RunLimits& limits)
{
    require_asked(scene, solver);
    RunResult result;
    result.contacts = limits.contacts;
    const PassObserver lap = [&](const std::string& pass) {
        result.timings.lap(pass);
        if (limits.times)
            limits.times->lap(pass);
    };
    const auto observe = [&] {
        for (Probe* probe : probes)
            probe->observe(scene.world, result.contacts, scene.dt);
    };

    if (!limits.may_gain_energy) {
        for (const std::string& warning : scene.warnings)
            warn_once(warning);
        if (scene.stiffness_warning && !solver.finds_stiffness)
            warn_once(*scene.stiffness_warning);
    }
    EnergyBudget budget(scene, result.contacts);
    const int steps = limits.steps.value_or(step_count(scene) - scene.world.step);
    Progress progress(scene.name + ", " + solver.name, steps);
    observe();
    while (result.steps < steps) {
        result.timings.start();  // again: what the probes take is not the step's
        if (limits.times)
            limits.times->begin();
        advance(scene.world, result.contacts, solver, scene.dt, lap);
        ++result.steps;
        observe();
        progress.update(result.steps);
        if (!result.energy_gain && (result.energy_gain = budget.exceeded(scene.world, result.contacts))) {
            const std::string run_of = scene.name + ", " + solver.name + ": ",
                              told = run_of + *result.energy_gain;
            if (!limits.may_gain_energy)
                throw std::runtime_error(told);
            warn_once(
                run_of,
                told + " (This run shows this on purpose; further warnings of this kind are left out.)");
        }
        if (limits.stop && limits.stop(scene.world, result.contacts))
            break;
    }
    if (const long badly = scene.world.ended_badly; badly > 0)
        warn_once(scene.name + ", " + solver.name + ": " + std::to_string(badly) +
                  (badly == 1 ? " step or part of one was" : " steps or parts of steps were") +
                  " not solved, turned a body too far or gained energy, and could not be halved any more; " +
                  std::to_string(scene.world.thrown_away) + " attempts were repeated in halves");
    return result;
}

}  // namespace enduring
