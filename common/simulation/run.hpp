#pragma once

#include "common/simulation/probes.hpp"
#include "common/simulation/scene.hpp"
#include "common/simulation/step.hpp"
#include "common/simulation/timings.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace enduring {

/// How long a run lasts; by default as long as its scene says.
struct RunLimits {
    std::optional<int> steps;                                       ///< instead of duration / dt
    std::function<bool(const World&, const Contacts&)> stop = {};   ///< asked after every step; true ends the run
};

struct RunResult {
    Contacts contacts;  ///< alive at the end
    Timings timings;    ///< of the passes; the probes' own time is not in it
    int steps = 0;
};

/// The loop of every experiment: steps a scene under a solver while probes watch, with progress on stderr.
///
/// @param scene   its world is moved on; run it again from a fresh load_scene()
/// @param probes  see the world once before the first step and then after each
/// @throws std::runtime_error  a NaN, with step, body and vertex (see advance())
RunResult run(Scene& scene, const Solver& solver, const std::vector<Probe*>& probes = {}, const RunLimits& limits = {});

/// Steps that cover the scene's duration: duration / dt, rounded up unless it is whole but for rounding.
int step_count(const Scene& scene);

}  // namespace enduring
