#include "common/simulation/run.hpp"

#include "common/simulation/progress.hpp"

#include <cmath>

namespace enduring {

int step_count(const Scene& scene)
{
    const double steps = scene.duration / scene.dt;
    const double whole = std::round(steps);
    return static_cast<int>(std::abs(steps - whole) < 1e-6 * steps ? whole : std::ceil(steps));
}

RunResult run(Scene& scene, const Solver& solver, const std::vector<Probe*>& probes, const RunLimits& limits)
{
    RunResult result;
    const PassTimer timer = [&result](const std::string& pass, double seconds) { result.timings.add(pass, seconds); };
    const auto observe = [&] {
        for (Probe* probe : probes)
            probe->observe(scene.world, result.contacts, scene.dt);
    };

    const int steps = limits.steps.value_or(step_count(scene));
    Progress progress(scene.name + ", " + solver.name, steps);
    observe();
    while (result.steps < steps) {
        advance(scene.world, result.contacts, solver, scene.dt, timer);
        ++result.steps;
        observe();
        progress.update(result.steps);
        if (limits.stop && limits.stop(scene.world, result.contacts))
            break;
    }
    return result;
}

}  // namespace enduring
