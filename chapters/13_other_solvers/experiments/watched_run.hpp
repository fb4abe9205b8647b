#pragma once

#include "chapters/13_other_solvers/experiments/method_table.hpp"

#include <array>

namespace enduring::chapter13 {

/// What a run looks like from outside, whatever its method says. Plain numbers and letters, to be kept by
/// sweep().
struct WatchedRun {
    double deepest_mm = 0;           ///< of all bodies in each other, in any step
    double deepest_end_mm = 0;       ///< the same behind the last step
    double drift_mm_per_s = 0;       ///< of the fastest centre over the last tenth of the run
    double gained_j = 0;             ///< most that the energy rose above its lowest so far
    double lost_j = 0;               ///< from the first energy to the lowest
    double step_ms = 0;              ///< processor time of a step
    double reached_s = 0;            ///< simulated: less than asked if the budget was used up
    std::array<char, 200> reason{};  ///< why the method has no answer; empty if it has

    bool is_defined() const { return reason[0] == '\0'; }
};

/// How a run is watched.
struct Watch {
    double seconds = 1;    ///< simulated
    double from = 0;       ///< from when on the time of a step counts [s]
    double budget_s = 60;  ///< of processor time, at which a run is left
    int depths = 5;        ///< steps from one look at depths to the next; 0 for none
};

WatchedRun watch_run(Scene scene, const MakeMethod& make, const Watch& watch);

}  // namespace enduring::chapter13
