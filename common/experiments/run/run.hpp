#pragma once

#include "common/experiments/run/probes.hpp"
#include "common/experiments/run/step_costs.hpp"
#include "common/experiments/run/timings.hpp"
#include "common/scenes/scene.hpp"
#include "common/simulation/step.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace enduring {

/// How long a run lasts; by default as long as its scene says.
struct RunLimits {
    std::optional<int> steps = {};  ///< instead of duration / dt
    /// asked after every step; true ends the run
    std::function<bool(const World&, const Contacts&)> stop = {};
    /// for what shows a failure on purpose: a gain of energy is told on stderr, and the run goes on
    bool may_gain_energy = false;
    Contacts contacts = {};      ///< pairs that live on from a run that is resumed
    StepTimes* times = nullptr;  ///< is told when a step begins, and of each of its passes
};

/// A limit of a run that shows on purpose how energy grows.
inline RunLimits failure_on_purpose(RunLimits limits = {})
{
    limits.may_gain_energy = true;
    return limits;
}

struct RunResult {
    Contacts contacts;  ///< alive at the end
    Timings timings;    ///< of the passes; the probes' own time is not in it
    int steps = 0;
    /// where the run first made energy out of nothing (see EnergyBudget); only if it may
    std::optional<std::string> energy_gain;
};

/// The loop of every experiment: steps a scene under a solver while probes watch,
/// with progress and the scene's warnings on stderr.
///
/// @param scene   its world is moved on; run it again from a fresh load_scene()
/// @param probes  see the world once before the first step and then after each
/// @throws std::runtime_error  a NaN, with step, body and vertex (see advance()); energy out of nothing,
///                             unless it may (see EnergyBudget). The probes have seen the step that is named
RunResult run(Scene& scene, const Solver& solver, const std::vector<Probe*>& probes = {},
              const RunLimits& limits = {});

/// Steps that cover the scene's duration: duration / dt, rounded up unless it is whole but for rounding.
int step_count(const Scene& scene);

}  // namespace enduring
